package dev.eventchain.agents.prompt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventchainPackage;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;

/** Tests the text of a metamodel in prompts. */
class MetamodelTextTest {
  private static final EPackage METAMODEL = EventChainMetamodel.documented();

  private static Set<String> named(String text, String pattern) {
    return Pattern.compile(pattern, Pattern.MULTILINE)
        .matcher(text)
        .results()
        .map(found -> found.group(1))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  @Test
  void everyClassAndFeatureHasALine() {
    String text = MetamodelText.of(METAMODEL, "EventChain", feature -> true);
    Set<String> classes = new TreeSet<>();
    Set<String> features = new TreeSet<>();
    for (EClass type :
        EventchainPackage.eINSTANCE.getEClassifiers().stream()
            .filter(EClass.class::isInstance)
            .map(EClass.class::cast)
            .toList()) {
      classes.add(type.getName());
      type.getEStructuralFeatures().forEach(feature -> features.add(feature.getName()));
    }
    assertEquals(classes, named(text, "^(?:abstract )?class (\\w+)"));
    assertEquals(features, named(text, "^  (\\w+): "));
    assertTrue(
        text.contains("  software: contains SoftwareNode [*] -- The software components"), text);
    assertTrue(text.contains("enum ComponentOrigin: EXISTING, GENERATED"), text);
  }

  @Test
  void modelsAreAskedForWhatADescriptionSaysOnly() {
    String text = ModelSchema.text(METAMODEL);
    for (String left :
        List.of(
            "measured",
            "latencyConstraints",
            "memory",
            "synchronized",
            "tolerance",
            "processors",
            "mappedTo",
            "priority",
            "componentUnit",
            "class Processor",
            "worstCaseTransportTime",
            "class Statistics",
            "percentile")) {
      assertFalse(text.contains(left), left);
    }
    assertTrue(text.contains("  topicName: String"), text);
  }
}
