package dev.eventchain.pipeline.generate;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.FieldType;
import dev.eventchain.templates.ShippedTemplates;
import org.junit.jupiter.api.Test;

/** Nodes convert values of the types that the contracts let through. */
class ConvertedTypesTest {

  @Test
  void templatesConvertTheNumbersOfMessages() {
    String units = ShippedTemplates.modules("python").apply("units").orElseThrow().text();
    assertTrue(units.contains(".matches('" + FieldType.NUMBER + "')"), units);
  }
}
