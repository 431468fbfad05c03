package dev.eventchain.modeler;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.RosNames;
import dev.eventchain.metamodel.TopicIndex;
import dev.eventchain.metamodel.eventchain.Data;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;

/** Whether a chain uses one existing component as it is: its code is there and will not change. */
final class ReuseCheck {

  private final SoftwareNode existing;
  private final SoftwareNode used;
  private final Function<EObject, SourceLocation> locator;
  private final List<Diagnostic> found;

  ReuseCheck(
      SoftwareNode existing,
      SoftwareNode used,
      Function<EObject, SourceLocation> locator,
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
                data,
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
    compareProperty(side, here, "topic", topic(there), topic(here));
    compareProperty(side, here, "field", there.getFieldName(), here.getFieldName());
    compareProperty(
        side,
        here,
        "message type",
        qualified(there.getMessageType()),
        qualified(here.getMessageType()));
  }

  private void compareFrequency(double wanted, double given) {
    if (wanted != given) {
      report(
          "value.changed",
          "The existing component '%s' executes with %s Hz, not %s Hz."
              .formatted(existing.getName(), wanted, given),
          used,
          "Describe an existing component as it is, or give the new one another name.");
    }
  }

  private void compareProperty(String side, Data here, String what, String wanted, String given) {
    if (!Objects.equals(wanted, given)) {
      report(
          "value.changed",
          "The %s of the %s '%s' of the existing component '%s' is '%s', not '%s'."
              .formatted(what, side, here.getName(), existing.getName(), wanted, given),
          here,
          "Describe an existing component as it is, or give the new one another name.");
    }
  }

  private void reportMissing(String side, String name) {
    String message =
        "The existing component '%s' has the %s '%s', which the chain leaves out."
            .formatted(existing.getName(), side, name);
    if (side.equals("input")) {
      report("value.missing", message, used, "Its code cannot be called without it.");
    } else {
      found.add(
          Diagnostic.warning("modeler.component.output.unused", message, locator.apply(used)));
    }
  }

  private void report(String kind, String message, EObject place, String hint) {
    found.add(
        Diagnostic.error("modeler.component." + kind, message, locator.apply(place))
            .withHint(hint));
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
