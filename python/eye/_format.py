"""printf() as LCDPrintf() knows it, for the values of Python."""

import functools as _functools
import re as _re

_CONVERSION = _re.compile(r"%([-+ #0]*)(\*|\d+)?(?:\.(\*|\d*))?(?:hh|h|ll|l|L|q|j|z|t)?([a-zA-Z%])")


def _number(value):
    """`value` as something that is counted or measured; a character is its code."""
    if isinstance(value, (str, bytes)):
        return ord(value) if len(value) == 1 else float(value)
    return getattr(value, "value", value)


def _text(value):
    if isinstance(value, (bytes, bytearray)):
        return bytes(value).decode("latin-1")
    return str(value)


def _character(value):
    if isinstance(value, (str, bytes)):
        return _text(value)[:1]
    return chr(int(_number(value)) & 0xFF)


def _whole(value):
    return value if type(value) is int else int(_number(value))


def _bits(value):
    """What C shows of an int in %u and %x."""
    number = _whole(value)
    return number if number >= 0 else number & 0xFFFFFFFF


def _real(value):
    return value if type(value) is float else float(_number(value))


# For each conversion of C: what makes the value, and Python's conversion for it.
_KINDS = {"d": (_whole, "d"), "i": (_whole, "d"), "u": (_bits, "d"), "c": (_character, "s"), "s": (_text, "s")}
_KINDS |= {kind: (_bits, kind) for kind in "xXo"} | {kind: (_real, kind) for kind in "eEfFgG"}
_KINDS["p"] = (lambda value: hex(_whole(value)), "s")


def _spec(flags, width, precision, kind):
    return f"%{flags}{width or ''}{'' if precision is None or kind == 'c' else '.' + precision}{_KINDS[kind][1]}"


@_functools.lru_cache(maxsize=512)
def _compiled(form):
    """`form` for Python's % operator, and what makes each value for it; None when it takes more than that."""
    makers = []

    def spec(match):
        flags, width, precision, kind = match.groups()
        if kind == "%":
            return "%%"
        if kind not in _KINDS or width == "*" or precision == "*":
            raise LookupError
        makers.append(_KINDS[kind][0])
        return _spec(flags, width, precision, kind)

    try:
        python_form = _CONVERSION.sub(spec, form)
    except LookupError:
        return None
    if python_form.replace("%%", "").count("%") != len(makers):
        return None  # one that is no conversion
    return python_form, makers


def _slowly(form, arguments):
    """One conversion after the other; those that cannot be shown stand as they are."""
    rest = iter(arguments)

    def shown(match):
        flags, width, precision, kind = match.groups()
        if kind == "%":
            return "%"
        if kind not in _KINDS:
            return match[0]
        try:
            if width == "*":
                width = str(_whole(next(rest)))
            if precision == "*":
                precision = str(max(_whole(next(rest)), 0))
            return _spec(flags, width, precision, kind) % _KINDS[kind][0](next(rest))
        except (StopIteration, TypeError, ValueError, OverflowError):
            return match[0]

    return _CONVERSION.sub(shown, form)


def c_format(form, arguments):
    """What printf(form, …) prints.

    Surplus arguments are ignored. A conversion without an argument, or with one that it cannot show, or that C does
    not know, is printed as it stands: the program goes on and its author sees where.
    """
    if type(form) is not str:
        form = _text(form)
    if "%" not in form:
        return form
    if len(arguments) == 1 and isinstance(arguments[0], (tuple, list)):
        arguments = arguments[0]
    compiled = _compiled(form)
    if compiled is not None and len(arguments) >= len(compiled[1]):
        try:
            return compiled[0] % tuple([make(value) for make, value in zip(compiled[1], arguments)])
        except (TypeError, ValueError, OverflowError):
            pass
    return _slowly(form, arguments)
