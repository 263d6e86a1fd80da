"""The first lines of the zygote: its own sources come in as text, so no folder of the package is on its path."""

import builtins
import json
import sys
import types


def install(package, modules):
    """Makes modules of texts, in the order given; relative imports among them work as in an ordinary package."""
    sys.modules[package] = types.ModuleType(package)
    sys.modules[package].__path__ = []
    for name, text in modules:
        module = types.ModuleType(f"{package}.{name}")
        module.__package__ = package
        # A copy of their own: a student who replaces `len` or `type` for everybody does not replace it here.
        module.__dict__["__builtins__"] = dict(vars(builtins))
        sys.modules[module.__name__] = module
        setattr(sys.modules[package], name, module)
        exec(compile(text, f"<{module.__name__}>", "exec"), module.__dict__)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    config = json.load(sys.stdin)
    sys.path.extend(config["libraries"])
    loaded: dict = sys.modules
    for name in config["absent"]:
        loaded[name] = None  # importing it then raises ModuleNotFoundError
    install("sandbox", config["modules"])
    sys.modules["sandbox.zygote"].serve(config)
