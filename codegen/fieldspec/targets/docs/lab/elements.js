// Elements of the page. Texts of specs and of users only ever become text nodes and values.

const MOST_CHARACTERS = 400;  // of a text that somebody pastes, within a message

function element(tag, properties = {}, ...children) {
  const { dataset, attributes, ...rest } = properties;
  const node = Object.assign(document.createElement(tag), rest);
  Object.assign(node.dataset, dataset);
  for (const [name, value] of Object.entries(attributes ?? {})) node.setAttribute(name, value);
  node.append(...children.filter((child) => child !== null && child !== ""));
  return node;
}

const byId = (id) => document.getElementById(id);

function shortened(text) {
  return text.length > MOST_CHARACTERS ? `${text.slice(0, MOST_CHARACTERS)} …` : text;
}

function option(value, text) {
  return element("option", { value, textContent: text });
}

// A name of a spec at the beginning of a label.
function titled(name) {
  return name.charAt(0).toUpperCase() + name.slice(1).replaceAll("_", " ");
}

// A text of the manual, in its language.
function labelText(device, text) {
  return text ? element("i", { lang: device.data.language, textContent: text }) : "";
}

async function copyText(text, button) {
  const before = button.dataset.text ?? button.textContent;
  button.dataset.text = before;
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = before; }, 2000);
  } catch {
    // The browser has no clipboard here, or forbids it: the text is there to be copied by hand.
    const field = byId("copy-text");
    field.hidden = false;
    field.value = text;
    field.focus();
    field.select();
  }
}
