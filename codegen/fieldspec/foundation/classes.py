"""Classes of data, as `dataclasses` makes them, in a tenth of the time.

The compiler has some two hundred of them, and many commands run for less time than the standard library takes to make
these, as it writes and compiles six methods of every class when it is imported. Here a class gets methods that are
shared by all, and its constructor is written when its first object is made. A frozen object is filled while it is of a
class that is not frozen, `_Open`, and then becomes what it is: a fifth of the time that the standard library takes.

To readers, type checkers and `dataclasses.fields` these are dataclasses. There is what the compiler uses: `frozen`,
`eq`, `kw_only`, and always slots; of fields, `default`, `default_factory`, `repr` and `compare`.
"""

from __future__ import annotations

TYPE_CHECKING = False
"""As of `typing`, for modules that take part in verbs which run for less time than that takes to import."""

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
    from dataclasses import field as field
    from dataclasses import replace as replace

    def attributes(cls: type) -> tuple[str, ...]:
        """The names of the attributes of a class of data, in order."""
else:
    from operator import attrgetter

    _MISSING = object()

    class _Field:
        """An attribute of a class: its default, and how objects compare and print it."""

        __slots__ = ("compare", "default", "factory", "kw_only", "name", "repr")

        def __init__(self, default, factory, repr, compare):
            self.default = default
            self.factory = factory
            self.repr = repr
            self.compare = compare

    def field(*, default=_MISSING, default_factory=_MISSING, repr=True, compare=True):
        """An attribute of which there is more to say than its type and its default."""
        return _Field(default, default_factory, repr, compare)

    def dataclass(*, slots, frozen=False, eq=True, kw_only=False):
        """Makes a class of data of one that has annotations."""
        assert slots
        return lambda cls: _data_class(cls, frozen, eq, kw_only)

    def attributes(cls):
        """The names of the attributes of a class of data, in order."""
        return tuple(cls._fields)

    def replace(instance, /, **changes):
        """The same object with some attributes changed."""
        return type(instance)._replaced(instance, **changes)

    def _data_class(cls, frozen, eq, kw_only):
        fields = {
            name: field for base in cls.__mro__[:0:-1] for name, field in base.__dict__.get("_fields", {}).items()
        }
        space = dict(cls.__dict__)
        assert "__post_init__" not in space, f"{cls.__name__}: nothing is called when an object is made"
        own = [name for name, kind in space.get("__annotations__", {}).items() if not kind.startswith("ClassVar")]
        for name in own:
            default = space.pop(name, _MISSING)
            attribute = default if isinstance(default, _Field) else _Field(default, _MISSING, True, True)
            attribute.name, attribute.kw_only = name, kw_only
            fields[name] = attribute
        for name in ("__dict__", "__weakref__"):
            space.pop(name, None)
        space |= {
            "__slots__": tuple(own),
            "__match_args__": tuple(attribute.name for attribute in fields.values() if not attribute.kw_only),
            "__dataclass_fields__": _StandardFields(),
            "__new__": _constructor,
            "__reduce__": _reduce,
            "_frozen": frozen,
            "_fields": fields,
            "_replaced": classmethod(_replacer),
        }
        shared = {"__repr__": _repr}
        if eq:
            compared = [attribute.name for attribute in fields.values() if attribute.compare]
            space["_compared"] = staticmethod(attrgetter(*compared) if compared else lambda instance: ())
            shared |= {"__eq__": _eq, "__hash__": _hash if frozen else None}
        if frozen:
            space |= {"__setattr__": _refused, "__delattr__": _refused}
        result = type(cls)(cls.__name__, cls.__bases__, {**shared, **space})
        result.__qualname__ = cls.__qualname__
        for method in space.values():
            _point(method, cls, result)
        return result

    def _point(method, old, new):
        """Lets a method that says `super()` mean the class with slots."""
        for cell in getattr(method, "__closure__", None) or ():
            if cell.cell_contents is old:
                cell.cell_contents = new

    def _constructor(cls, /, *values, **keywords):
        """Writes the constructor of a class, when its first object is made."""
        owner = next(base for base in cls.__mro__ if "_fields" in base.__dict__)
        owner.__new__ = staticmethod(_compiled_constructor(owner))
        return owner.__new__(cls, *values, **keywords)

    def _compiled_constructor(owner):
        positional = [attribute for attribute in owner._fields.values() if not attribute.kw_only]
        keyword_only = [attribute for attribute in owner._fields.values() if attribute.kw_only]
        parameters = [*map(_parameter, positional), *(["*"] if keyword_only else []), *map(_parameter, keyword_only)]
        return _compiled(owner, f"make(cls, {', '.join(parameters)})", "cls", _value)

    def _parameter(attribute):
        if attribute.default is _MISSING and attribute.factory is _MISSING:
            return attribute.name
        return f"{attribute.name}=_default_{attribute.name}"

    def _value(attribute):
        if attribute.factory is _MISSING:
            return attribute.name
        return f"_factory_{attribute.name}() if {attribute.name} is _MISSING else {attribute.name}"

    def _replacer(owner, instance, /, **changes):
        """Writes the function that copies objects of a class, when the first is copied."""
        parameters = "".join(f", {name}=_MISSING" for name in owner._fields)
        head = f"make(held, /, *{parameters})" if parameters else "make(held, /)"
        owner._replaced = staticmethod(_compiled(owner, head, "held.__class__", _copied))
        return owner._replaced(instance, **changes)

    def _copied(attribute):
        return f"held.{attribute.name} if {attribute.name} is _MISSING else {attribute.name}"

    def _compiled(owner, head, final, value):
        """A function that makes an object and gives each attribute a value."""
        lines = [f"def {head}:", f"    self = _new({'_open' if owner._frozen else final})"]
        lines += [f"    self.{attribute.name} = {value(attribute)}" for attribute in owner._fields.values()]
        lines += [f"    self.__class__ = {final}"] if owner._frozen else []
        lines += ["    return self"]
        space = {"_new": object.__new__, "_open": _opened(owner), "_MISSING": _MISSING}
        for attribute in owner._fields.values():
            space[f"_default_{attribute.name}"] = attribute.default
            space[f"_factory_{attribute.name}"] = attribute.factory
        exec("\n".join(lines), space)
        function = space["make"]
        function.__qualname__ = f"{owner.__qualname__}.__new__"
        function.__module__ = owner.__module__
        return function

    def _opened(owner):
        """A class like another one that is not frozen; for a frozen class, it is made with its first object."""
        if owner._frozen and "_Open" not in owner.__dict__:
            owner._Open = type("_Open", (owner,), {"__slots__": (), **_OPEN})
        return owner._Open if owner._frozen else owner

    def _eq(self, other):
        if other.__class__ is not self.__class__:
            return NotImplemented
        return self is other or self._compared(self) == other._compared(other)

    def _hash(self):
        return hash(self._compared(self))

    def _repr(self):
        values = ", ".join(
            f"{attribute.name}={getattr(self, attribute.name)!r}"
            for attribute in self._fields.values()
            if attribute.repr
        )
        return f"{self.__class__.__qualname__}({values})"

    def _reduce(self):
        return _rebuilt, (self.__class__, {name: getattr(self, name) for name in self._fields})

    def _rebuilt(cls, values):
        return cls(**values)

    def _refused(self, name, *value):
        from dataclasses import FrozenInstanceError

        raise FrozenInstanceError(f"cannot assign to field {name!r}")

    _OPEN = {"__setattr__": object.__setattr__, "__delattr__": object.__delattr__}

    class _StandardFields:
        """What `dataclasses` asks a class for, made when it asks."""

        def __get__(self, instance, owner):
            from dataclasses import field, make_dataclass

            def standard(attribute):
                factory = {} if attribute.factory is _MISSING else {"default_factory": attribute.factory}
                default = {} if attribute.default is _MISSING else {"default": attribute.default}
                return field(
                    repr=attribute.repr, compare=attribute.compare, kw_only=attribute.kw_only, **factory, **default
                )

            fields = [(name, "object", standard(attribute)) for name, attribute in owner._fields.items()]
            owner.__dataclass_fields__ = make_dataclass(owner.__name__, fields).__dataclass_fields__
            return owner.__dataclass_fields__
