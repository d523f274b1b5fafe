"""The types of the generated JavaScript: the compiler of TypeScript accepts right programs and refuses wrong ones."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

from external_tools import require_tool
from js_output.javascript import package

PROGRAM = Path(__file__).with_name("program.ts")

OPTIONS = {
    "strict": True,
    "noEmit": True,
    "target": "es2022",
    "module": "nodenext",
    "moduleResolution": "nodenext",
    "lib": ["es2022"],
    "types": [],
    "skipLibCheck": False,
    "exactOptionalPropertyTypes": True,
    "noUncheckedIndexedAccess": True,
}


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project that has the generated modules as a package."""
    folder = tmp_path_factory.mktemp("project")
    shutil.copytree(package(), folder / "node_modules" / "fieldspec-devices")
    shutil.copy(PROGRAM, folder)
    types = "node_modules/fieldspec-devices/**/*.d.ts"
    config = {"compilerOptions": OPTIONS, "include": [PROGRAM.name, types], "exclude": []}
    (folder / "package.json").write_text('{"type": "module"}', "utf-8")
    (folder / "tsconfig.json").write_text(json.dumps(config), "utf-8")
    return folder


def test_the_types_of_all_devices_are_strictly_right(project: Path) -> None:
    run = subprocess.run([require_tool("tsc"), "-p", "."], cwd=project, capture_output=True, text=True, check=False)
    assert run.stdout == ""
    assert run.returncode == 0


def test_a_module_exports_what_its_types_declare(project: Path) -> None:
    script = """
    import { readdirSync, readFileSync } from "node:fs";
    const root = "node_modules/fieldspec-devices/";
    for (const device of readdirSync(root)) {
      if (device === "runtime" || device.endsWith(".json")) continue;
      for (const file of readdirSync(root + device)) {
        if (!file.endsWith(".js") || ["index.js", "explain.js"].includes(file)) continue;
        const types = readFileSync(`${root}${device}/${file.replace(".js", ".d.ts")}`, "utf8");
        const declared = [...types.matchAll(/^export declare (?:const|function) ([\\w$]+)/gm)].map((match) => match[1]);
        const exported = Object.keys(await import(`./${root}${device}/${file}`));
        const different = [...new Set(declared)].sort().join() !== exported.sort().join();
        if (different) console.log(device, file, declared.filter((name) => !exported.includes(name)),
          exported.filter((name) => !declared.includes(name)));
      }
    }
    """
    (project / "exports.mjs").write_text(script, "utf-8")
    run = subprocess.run(
        [require_tool("node"), "exports.mjs"], cwd=project, capture_output=True, text=True, check=False
    )
    assert (run.stdout, run.stderr) == ("", "")


def test_the_program_runs_as_its_comments_say(project: Path) -> None:
    tsc = [require_tool("tsc"), PROGRAM.name, "--target", "es2022", "--module", "nodenext", "--lib", "es2022,dom"]
    subprocess.run([*tsc, "--outDir", "out"], cwd=project, capture_output=True, text=True, check=False)
    run = subprocess.run(
        [require_tool("node"), "out/program.js"], cwd=project, capture_output=True, text=True, check=False
    )
    assert (run.stdout, run.stderr) == ("", "")
