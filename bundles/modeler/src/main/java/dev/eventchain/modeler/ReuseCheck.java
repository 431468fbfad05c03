package dev.eventchain.modeler;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.RosNames;
import dev.eventchain.metamodel.TopicIndex;
import dev.eventchain.metamodel.eventchain.Data;
import dev.eventchain.metamodel.eventchain.EventchainPackage.Literals;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.BiFunction;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Whether a chain uses one existing component as it is: its code is there and will not change. */
final class ReuseCheck {

  private static final Map<EStructuralFeature, String> WORDS =
      Map.of(
          Literals.DATA__TOPIC_NAME, "topic",
          Literals.DATA__FIELD_NAME, "field",
          Literals.DATA__MESSAGE_TYPE, "message type");

  private final SoftwareNode existing;
  private final SoftwareNode used;
  private final BiFunction<EObject, EStructuralFeature, SourceLocation> locator;
  private final List<Diagnostic> found;

  ReuseCheck(
      SoftwareNode existing,
      SoftwareNode used,
      BiFunction<EObject, EStructuralFeature, SourceLocation> locator,
      List<Diagnostic> found) {
    this.existing = existing;
    this.used = used;
    this.locator = locator;
    this.found = found;
  }

  void check() {
    compare("input", byName(existing.getInput()), byName(used.getInput()));
    compare("output", byName(existing.getOutput()), byName(used.getOutput()));
    if (existing.isSetFrequency() && used.isSetFrequency()) {
      compareFrequency(existing.getFrequency(), used.getFrequency());
    }
  }

  private void compare(String side, Map<String, Data> there, Map<String, Data> here) {
    here.forEach(
        (name, data) -> {
          if (!there.containsKey(name)) {
            report(
                "value.unknown",
                "The existing component '%s' has no %s '%s'."
                    .formatted(existing.getName(), side, name),
                locator.apply(data, Literals.DATA__NAME),
                NearestName.hint(name, there.keySet()));
          } else {
            compareValue(side, there.get(name), data);
          }
        });
    there.forEach(
        (name, data) -> {
          if (!here.containsKey(name)) {
            reportMissing(side, name);
          }
        });
  }

  private void compareValue(String side, Data there, Data here) {
    compareProperty(side, here, Literals.DATA__TOPIC_NAME, topic(there), topic(here));
    compareProperty(
        side, here, Literals.DATA__FIELD_NAME, there.getFieldName(), here.getFieldName());
    compareProperty(
        side,
        here,
        Literals.DATA__MESSAGE_TYPE,
        qualified(there.getMessageType()),
        qualified(here.getMessageType()));
  }

  private void compareFrequency(double wanted, double given) {
    if (wanted != given) {
      report(
          "value.changed",
          "The existing component '%s' executes with %s Hz, not %s Hz."
              .formatted(existing.getName(), wanted, given),
          locator.apply(used, Literals.SOFTWARE_NODE__FREQUENCY),
          "Describe an existing component as it is, or give the new one another name.");
    }
  }

  private void compareProperty(
      String side, Data here, EStructuralFeature feature, String wanted, String given) {
    if (!Objects.equals(wanted, given)) {
      report(
          "value.changed",
          "The %s of the %s '%s' of the existing component '%s' is '%s', not '%s'."
              .formatted(
                  WORDS.get(feature), side, here.getName(), existing.getName(), wanted, given),
          locator.apply(here, feature),
          "Describe an existing component as it is, or give the new one another name.");
    }
  }

  private void reportMissing(String side, String name) {
    String message =
        "The existing component '%s' has the %s '%s', which the chain leaves out."
            .formatted(existing.getName(), side, name);
    if (side.equals("input")) {
      report("value.missing", message, at(side), "Its code cannot be called without it.");
    } else {
      found.add(Diagnostic.warning("modeler.component.output.unused", message, at(side)));
    }
  }

  private SourceLocation at(String side) {
    return locator.apply(
        used,
        side.equals("input") ? Literals.SOFTWARE_NODE__INPUT : Literals.SOFTWARE_NODE__OUTPUT);
  }

  private void report(String kind, String message, SourceLocation place, String hint) {
    found.add(Diagnostic.error("modeler.component." + kind, message, place).withHint(hint));
  }

  private String topic(Data data) {
    return TopicIndex.nameOf(data, existing).orElse("");
  }

  private static String qualified(String type) {
    return type == null ? "" : RosNames.fullMessageType(type);
  }

  private static Map<String, Data> byName(List<Data> data) {
    Map<String, Data> values = new LinkedHashMap<>();
    data.forEach(value -> values.putIfAbsent(String.valueOf(value.getName()), value));
    return values;
  }
}
