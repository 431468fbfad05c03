package dev.eventchain.pipeline.generate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the dependencies that the components' imports require. */
class ComponentImportsTest {

  private static ComponentImports of(String text, boolean pip) {
    ComponentImports imports =
        new ComponentImports(MessageCatalog.of(List.of()), pip, Set.of("helper"));
    imports.add("The component 'Component'", SourceText.of("Component.py", text));
    return imports;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "import numpy",
        "import math, numpy.linalg as la",
        "from numpy import (\n    array,\n)",
        "from numpy.linalg import norm; x = 1",
        "class A:\n    def f(self):\n        if True: import numpy",
        "import math; import numpy # as np",
        "import \\\n    numpy",
        "import \\\r\n    numpy",
        "text = '''it's \\''' here'''\nimport numpy",
        "text = r'\\'\nimport numpy",
        "text = 'never ended\nimport numpy"
      })
  void anImportIsFoundWhereverItStands(String text) {
    assertEquals(Set.of("python3-numpy"), of(text, false).rosdepKeys());
    assertEquals(Set.of("numpy"), of(text, true).pipNames());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "import math",
        "from collections.abc import Sequence",
        "from __future__ import annotations",
        "from . import numpy",
        "from .numpy import array",
        "# import numpy",
        "text = 'import numpy'",
        "\"\"\"A text.\n\nimport numpy\n\"\"\"",
        "text = '''\nfrom numpy import x\n'''",
        "def f():\n    yield from numpy\n    raise A from numpy",
        "importnumpy = reimport"
      })
  void whatIsNoImportOrOfPythonItselfNeedsNothing(String text) {
    ComponentImports imports = of(text, false);
    assertEquals(Set.of(), imports.rosdepKeys());
    assertEquals(List.of(), imports.unknown());
  }

  @Test
  void packagesOfRosAreCalledAsTheyAre() {
    String text = "from std_msgs.msg import Bool\nimport geometry_msgs.msg\nimport rclpy\n";
    ComponentImports imports = of(text, false);
    assertEquals(Set.of("geometry_msgs", "rclpy", "std_msgs"), imports.rosdepKeys());
    assertEquals(List.of(), imports.unknown());
    assertEquals(3, of(text, true).unknown().size(), "pip does not have them");
  }

  @Test
  void whatNobodyKnowsIsSaidWhereItStands() {
    List<Diagnostic> unknown = of("import math\nimport shapely.geometry\n", false).unknown();
    assertEquals(1, unknown.size());
    assertEquals("project.dependency.unknown", unknown.get(0).id());
    assertEquals("Component.py:2:1", unknown.get(0).location().toString());
  }
}
