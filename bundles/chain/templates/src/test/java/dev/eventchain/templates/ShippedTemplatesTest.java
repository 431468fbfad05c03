package dev.eventchain.templates;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import java.util.Optional;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

/** Shipped modules are found by the names in imports. */
class ShippedTemplatesTest {

  private static Optional<String> named(
      Function<String, Optional<SourceText>> modules, String name) {
    return modules.apply(name).map(SourceText::name);
  }

  @Test
  void eachSetHasItsMain() {
    for (String set : ShippedTemplates.sets()) {
      assertTrue(ShippedTemplates.module(set, "main").isPresent(), set);
    }
  }

  @Test
  void whatAModuleImportsIsOfItsOwnSet() {
    Function<String, Optional<SourceText>> modules = ShippedTemplates.modules("ros2-python");
    assertEquals(Optional.of("templates/ros2-python/main.mtl"), named(modules, "main"));
    assertEquals(
        Optional.of("templates/cyclonedds-python/main.mtl"),
        named(modules, "cyclonedds_python::main"));
    assertEquals(Optional.of("templates/cyclonedds-python/main.mtl"), named(modules, "main"));
    assertEquals(Optional.of("templates/python/names.mtl"), named(modules, "names"));
  }

  @Test
  void namesLeadNowhereElse() {
    for (String name : new String[] {"..::main", "python::../../pom", "", "nothing"}) {
      assertEquals(
          Optional.empty(), ShippedTemplates.modules(ShippedTemplates.DEFAULT).apply(name), name);
    }
  }
}
