package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.RosNames;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.ComponentUnits;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Checks that a chain uses an existing component as described, because its code will not change.
 */
final class ReuseCheck {

  private static final String NOT_STATED = "";

  /** A compared property of data. The type of a field follows from its message. */
  private record Property(
      EStructuralFeature feature, String words, boolean optional, Function<Data, String> value) {}

  private static final List<Property> PROPERTIES =
      List.of(
          new Property(Literals.DATA__FIELD_NAME, "field", false, Data::getFieldName),
          new Property(Literals.DATA__MESSAGE_TYPE, "message type", false, ReuseCheck::type),
          new Property(Literals.DATA__UNIT, "unit", true, data -> stated(data.getUnit())),
          new Property(Literals.DATA__COMPONENT_UNIT, "component unit", false, ComponentUnits::of),
          new Property(Literals.DATA__QOS, "quality of service", true, ReuseCheck::quality),
          new Property(Literals.DATA__MAXIMUM_AGE, "maximum age", true, ReuseCheck::age),
          new Property(
              Literals.DATA__SAFE_VALUE, "safe value", true, data -> stated(data.getSafeValue())));

  private static final Set<EStructuralFeature> UNITS =
      Set.of(Literals.DATA__UNIT, Literals.DATA__COMPONENT_UNIT);

  private static final Map<EAttribute, String> NUMBERS = new LinkedHashMap<>();

  static {
    NUMBERS.put(Literals.SOFTWARE_NODE__FREQUENCY, "frequency (Hz)");
    NUMBERS.put(Literals.SOFTWARE_NODE__BEST_CASE_EXECUTION_TIME, "best-case execution time (ms)");
    NUMBERS.put(
        Literals.SOFTWARE_NODE__WORST_CASE_EXECUTION_TIME, "worst-case execution time (ms)");
    NUMBERS.put(Literals.SOFTWARE_NODE__MEMORY, "memory");
    NUMBERS.put(Literals.SOFTWARE_NODE__TOLERANCE, "tolerance (ms)");
  }

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
    NUMBERS.forEach(this::compareNumber);
    compareSynchronization();
  }

  private void compare(String side, Map<String, Data> there, Map<String, Data> here) {
    here.forEach(
        (name, data) -> {
          if (!there.containsKey(name)) {
            report(
                ProjectRules.MODELER_COMPONENT_VALUE_UNKNOWN,
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
    String owner = "the %s '%s' of ".formatted(side, here.getName());
    compare("topic", owner, here, Literals.DATA__TOPIC_NAME, topic(there), topic(here));
    for (Property property : PROPERTIES) {
      String wanted = property.value().apply(there);
      String given = property.value().apply(here);
      boolean unknown =
          property.feature() == Literals.DATA__COMPONENT_UNIT
              ? !ComponentUnits.isConverted(there) && !ComponentUnits.isConverted(here)
              : property.optional() && NOT_STATED.equals(wanted);
      boolean same = UNITS.contains(property.feature()) && isSameUnit(wanted, given);
      if (!unknown && !same) {
        compare(property.words(), owner, here, property.feature(), wanted, given);
      }
    }
  }

  /** Compares a number; the chain may add one that the existing component does not state. */
  private void compareNumber(EAttribute attribute, String words) {
    if (existing.eIsSet(attribute)) {
      String given = used.eIsSet(attribute) ? String.valueOf(used.eGet(attribute)) : NOT_STATED;
      compare(words, "", used, attribute, String.valueOf(existing.eGet(attribute)), given);
    }
  }

  /** Compares the synchronized topics; the chain may add some if the component states none. */
  private void compareSynchronization() {
    String wanted = String.join(", ", TopicIndex.synchronizedBy(existing));
    String given = String.join(", ", TopicIndex.synchronizedBy(used));
    if (!wanted.isEmpty()) {
      compare("synchronized topics", "", used, Literals.SOFTWARE_NODE__SYNCHRONIZED, wanted, given);
    }
  }

  private void compare(
      String words,
      String owner,
      EObject here,
      EStructuralFeature feature,
      String wanted,
      String given) {
    if (!Objects.equals(wanted, given)) {
      report(
          ProjectRules.MODELER_COMPONENT_VALUE_CHANGED,
          "The %s of %sthe existing component '%s' is '%s', %s."
              .formatted(
                  words,
                  owner,
                  existing.getName(),
                  wanted,
                  NOT_STATED.equals(given)
                      ? "which the chain does not state"
                      : "not '" + given + "'"),
          locator.apply(here, feature),
          "Describe an existing component as it is, or give the new one another name.");
    }
  }

  private void reportMissing(String side, String name) {
    String message =
        "The existing component '%s' has the %s '%s', which the chain leaves out."
            .formatted(existing.getName(), side, name);
    if (side.equals("input")) {
      report(
          ProjectRules.MODELER_COMPONENT_VALUE_MISSING,
          message,
          at(side),
          "Its code cannot be called without it.");
    } else {
      found.add(Diagnostic.of(ProjectRules.MODELER_COMPONENT_OUTPUT_UNUSED, message, at(side)));
    }
  }

  private SourceLocation at(String side) {
    return locator.apply(
        used,
        side.equals("input") ? Literals.SOFTWARE_NODE__INPUT : Literals.SOFTWARE_NODE__OUTPUT);
  }

  private void report(Rule rule, String message, SourceLocation place, String hint) {
    found.add(Diagnostic.of(rule, message, place).withHint(hint));
  }

  private String topic(Data data) {
    return TopicIndex.nameOf(data, existing).orElse("");
  }

  private static String type(Data data) {
    String type = data.getMessageType();
    return type == null ? NOT_STATED : RosNames.fullMessageType(type);
  }

  private static String stated(String text) {
    return text == null ? NOT_STATED : text;
  }

  private static String age(Data data) {
    return data.isSetMaximumAge() ? data.getMaximumAge() + " ms" : NOT_STATED;
  }

  private static boolean isSameUnit(String one, String other) {
    return Unit.parse(one)
        .flatMap(unit -> Unit.parse(other).map(unit::relationTo))
        .filter(relation -> relation == Unit.Relation.SAME)
        .isPresent();
  }

  /** Returns the profile with its overrides: "sensor_data, depth 5". */
  private static String quality(Data data) {
    QosProfile profile = data.getQos();
    if (profile == null) {
      return NOT_STATED;
    }
    List<String> parts = new ArrayList<>();
    for (EAttribute policy : profile.eClass().getEAllAttributes()) {
      if (profile.eIsSet(policy)) {
        String value = String.valueOf(profile.eGet(policy)).toLowerCase(Locale.ROOT);
        parts.add(policy.getName().equals("name") ? value : policy.getName() + " " + value);
      }
    }
    return String.join(", ", parts);
  }

  private static Map<String, Data> byName(List<Data> data) {
    Map<String, Data> values = new LinkedHashMap<>();
    data.forEach(value -> values.putIfAbsent(String.valueOf(value.getName()), value));
    return values;
  }
}
