package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PythonNamesTest {

  @ParameterizedTest
  @CsvSource({
    "TTC_Calculation,TTC_Calculation,ttc_calculation_node,TTC_Calculation_node",
    "../../x,_x,_x_node,_x_node",
    "class,class_,class__node,class__node",
    "2nd brake,_2nd_brake,_2nd_brake_node,_2nd_brake_node",
    "a\"],a__,a___node,a___node"
  })
  void namesAreThoseOfTheGeneratedFiles(
      String name, String identifier, String module, String nodeClass) {
    assertEquals(identifier, PythonNames.identifier(name));
    assertEquals(module, PythonNames.nodeModule(name));
    assertEquals(nodeClass, PythonNames.nodeClass(name));
  }
}
