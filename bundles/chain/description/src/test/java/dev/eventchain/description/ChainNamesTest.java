package dev.eventchain.description;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.junit.jupiter.api.Test;

/** Tests the table of names against the schema and the metamodel. */
class ChainNamesTest {

  /**
   * Names that no language model is asked for: they are added by hand, or for existing software.
   */
  private static final List<String> EXISTING =
      List.of(
          "best_case_execution_time",
          "component_unit",
          "file",
          "implementation",
          "memory",
          "node",
          "priority",
          "processor",
          "synchronized",
          "tolerance",
          "worst_case_transport_time");

  @Test
  void theSchemaHasTheNamesOfTheTable() throws IllegalAccessException {
    Set<String> names = new TreeSet<>();
    for (Field field : ChainNames.class.getFields()) {
      if (Modifier.isStatic(field.getModifiers())) {
        names.add((String) field.get(null));
      }
    }
    names.remove(ChainNames.EXTERNAL);
    EXISTING.forEach(names::remove);
    Set<String> properties = new TreeSet<>();
    collect(EventChainSchema.of(List.of("R-1"), List.of()).nested(), properties);
    assertEquals(names, properties);
  }

  private static void collect(JsonNode schema, Set<String> properties) {
    schema.path("properties").fieldNames().forEachRemaining(properties::add);
    schema.forEach(each -> collect(each, properties));
  }

  /** The writer throws if a policy has no name. */
  @Test
  void eachPolicyHasAName() {
    for (EStructuralFeature policy : Literals.QOS_PROFILE.getEStructuralFeatures()) {
      if (policy.isUnsettable()) {
        String snakeCase = policy.getName().replaceAll("(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
        assertEquals(Optional.of(snakeCase), ChainNames.of(policy));
      }
    }
  }
}
