"""Small facades on which constraint kinds are tried: few enough words to go through them all."""

from __future__ import annotations

from collections.abc import Mapping

_ROW = """
  <region symbol="Facade" width="8" height="3" split="columns" labels="Floor">
    <region symbol="Pier" width="1" labels="Wall"/>
    <region symbol="Window" width="2" labels="Window"/>
    <again symbol="Pier"/>
    <region symbol="Door" width="1.5" labels="Door"/>
    <region symbol="Shop" width="2.5" labels="Shop"/>
  </region>
"""

_HOUSE = """
  <region symbol="Facade" width="7" height="9" split="rows">
    <region symbol="Roof" height="1" labels="Roof"/>
    <region symbol="Floor" height="2.5" split="columns" labels="Floor">
      <region symbol="Pier" width="1" labels="Wall"/>
      <region symbol="Bay" width="2" split="rows" labels="Bay">
        <region symbol="Over" height="0.5" labels="Wall"/>
        <region symbol="Window" height="1.4" labels="Window"/>
        <region symbol="Under" height="0.6" labels="Wall"/>
      </region>
      <again symbol="Pier"/>
      <again symbol="Bay"/>
      <again symbol="Pier"/>
    </region>
    <again symbol="Floor"/>
    <region symbol="Ground" height="3" split="columns" labels="Floor">
      <region symbol="Pier" width="1" labels="Wall"/>
      <region symbol="Shop" width="2.5" split="rows" labels="Shop">
        <region symbol="Sign" height="0.6" labels="Sign"/>
        <region symbol="Door" height="2.4" labels="Door"/>
      </region>
      <region symbol="Door" width="1.5" labels="Door"/>
      <again symbol="Pier"/>
      <region symbol="Window" width="1" labels="Window"/>
    </region>
  </region>
"""


def document(name: str, regions: str, elements: str, declarations: Mapping[str, str]) -> str:
    """Return a facade document.

    Parameters
    ----------
    regions, elements
        What stands in it, as XML: the region tree, and the constraints.
    declarations
        Namespaces of the elements, by prefix.
    """
    spaces = "".join(f' xmlns:{prefix}="{uri}"' for prefix, uri in declarations.items() if prefix)
    head = f'<facade xmlns="urn:layoutkit:1"{spaces} name="{name}" units="m">'
    return f"{head}{regions}  <constraints>\n    {elements}\n  </constraints>\n</facade>\n"


#: Region trees by name. Their labels: Wall, Window, Door, Shop, Floor; in `house` Roof, Bay and Sign as well.
HOUSES: Mapping[str, str] = {"row": _ROW, "house": _HOUSE}
