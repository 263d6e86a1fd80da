"""Packages that students may import: declared by a set or a course, installed here or not."""

from __future__ import annotations

import re
import sys
from collections.abc import Collection, Iterable
from importlib.machinery import PathFinder
from importlib.metadata import PackageNotFoundError, version

MODULE = re.compile(r"[A-Za-z_]\w{0,79}$")
ALWAYS = ("numpy", "scipy", "matplotlib", "sympy", "IPython")
"""Installed with Corollary, so that no set need declare them."""

# The name to install a module by, for those that students of physics import. Another name is not recommended for
# installation: it may be a misprint that somebody has registered, or a file of the student's own.
_BY_THEIR_NAMES = (
    "numpy scipy matplotlib sympy pandas seaborn plotly bokeh altair pint uncertainties astropy numba networkx statsmodels "
    "lmfit iminuit emcee xarray h5py openpyxl requests tqdm mpmath vpython qutip control numexpr ipywidgets ipympl "
    "autograd cvxpy pymc plasmapy periodictable tabulate joblib"
)
INSTALLED_AS = dict(zip(_BY_THEIR_NAMES.split(), _BY_THEIR_NAMES.split(), strict=True)) | {
    "sklearn": "scikit-learn",
    "skimage": "scikit-image",
    "PIL": "pillow",
    "cv2": "opencv-python",
    "yaml": "pyyaml",
    "bs4": "beautifulsoup4",
    "scienceplots": "SciencePlots",
    "mpl_toolkits": "matplotlib",
}  # fmt: skip
IMPORTED_AS = {
    distribution: module for module, distribution in INSTALLED_AS.items() if distribution not in INSTALLED_AS
}


def module_named(word: str) -> str:
    """The name to import by, of what may be the name to install by: `scikit-learn` is `sklearn`."""
    return IMPORTED_AS.get(word, word)


def is_installed(module: str) -> bool:
    """True if the module can be found in this environment, the standard library included; nothing is imported."""
    if module in sys.builtin_module_names:
        return True
    try:
        return PathFinder.find_spec(module, [each for each in sys.path if each]) is not None
    except (ImportError, ValueError):
        return False


def version_of(module: str) -> str:
    """The version of an installed module; empty where it has none."""
    try:
        return version(INSTALLED_AS.get(module, module))
    except PackageNotFoundError:
        found = sys.modules.get(module)
        return str(getattr(found, "__version__", "")) if found is not None else ""


def is_of_another_system(module: str) -> bool:
    """True for a module that only another operating system, or Google Colab, has: winsound, google.colab."""
    return module in sys.stdlib_module_names or module == "google"


def state_of_package(module: str, declared: Collection[str] | None) -> str:
    """`installed`; `not allowed`: a list is declared, and it is not in it; else `missing`."""
    if is_installed(module):
        return "installed"
    not_allowed = declared is not None and module not in {*declared, *ALWAYS}
    return "not allowed" if not_allowed and not is_of_another_system(module) else "missing"


def missing_of(declared: Iterable[str]) -> list[str]:
    """The declared packages that are not installed here."""
    return [each for each in declared if not is_installed(each)]


def fault(word: object) -> str:
    """What is wrong with the name of a package; empty where nothing is."""
    if isinstance(word, str) and MODULE.match(module_named(word)):
        return ""
    return f"packages: {word} is not a package; write names as they are imported, such as pandas"


def listed(declared: Iterable[str] | None) -> list[str]:
    """All packages that students may rely on, those that are always there first."""
    return list(dict.fromkeys((*ALWAYS[:-1], *(declared or ()))))
