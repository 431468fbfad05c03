package dev.eventchain.lsp.project;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Inputs and outputs of a component, as its tests in YAML name them. */
final class ComponentNames {

  private static final Set<String> OF_INPUTS = Set.of("inputs", "over");
  private static final String OF_OUTPUTS = "outputs";

  /** The keys of a property whose value is an input. */
  private static final Set<String> INPUT = Set.of("rises_with", "falls_with");

  private static final String OUTPUT = "output";

  /** The keys of a value below an input or an output: of an expectation, or of an array. */
  private static final Set<String> VALUE = Set.of("value", "of");

  private final ProjectFiles project;
  private final Optional<SoftwareNode> component;

  ComponentNames(ProjectFiles project, String component) {
    this.project = project;
    this.component = project.component(component);
  }

  /** Returns the inputs or outputs that may be keys at a path, with what is known of them. */
  Map<String, String> keys(List<String> path) {
    String last = path.isEmpty() ? "" : path.get(path.size() - 1);
    return OF_INPUTS.contains(last)
        ? described(inputs())
        : last.equals(OF_OUTPUTS) ? described(outputs()) : Map.of();
  }

  /** Returns the inputs or outputs that the value of a property may be, or the named values. */
  Map<String, String> values(YamlPlace place) {
    String last = place.lastKey();
    if (place.path().size() == 3 && last.equals(OUTPUT)) {
      return described(outputs());
    } else if (place.path().size() == 3 && INPUT.contains(last)) {
      return described(inputs());
    }
    Map<String, String> found = new LinkedHashMap<>();
    value(place.path()).ifPresent(it -> names(it).forEach(name -> found.put(name, "")));
    return found;
  }

  /** Returns the input or output whose value a path leads to. */
  private Optional<Data> value(List<String> path) {
    List<String> steps = path.stream().filter(each -> !each.equals(YamlPlace.ITEM)).toList();
    int size = steps.size();
    boolean isBelow =
        size > 2 && VALUE.contains(steps.get(size - 1)) && isOfValues(steps.get(size - 3));
    int at = isBelow ? size - 2 : size - 1;
    if (at < 1 || !isOfValues(steps.get(at - 1))) {
      return Optional.empty();
    }
    List<Data> all = steps.get(at - 1).equals(OF_OUTPUTS) ? outputs() : inputs();
    return all.stream().filter(each -> steps.get(at).equals(each.getName())).findFirst();
  }

  private static boolean isOfValues(String key) {
    return key.equals("inputs") || key.equals(OF_OUTPUTS);
  }

  /** Returns the values that have names; those of numbers are written as numbers in tests. */
  private List<String> names(Data value) {
    return switch (text(value.getType()).replaceFirst("\\[.*", "")) {
      case "bool", "boolean" -> List.of("true", "false");
      case "string" -> project.valueNames(text(value.getTopicName()), text(value.getFieldName()));
      default -> List.of();
    };
  }

  private List<Data> inputs() {
    return component.map(it -> List.copyOf(it.getInput())).orElse(List.of());
  }

  private List<Data> outputs() {
    return component.map(it -> List.copyOf(it.getOutput())).orElse(List.of());
  }

  private static Map<String, String> described(List<Data> values) {
    Map<String, String> found = new LinkedHashMap<>();
    values.stream()
        .filter(each -> each.getName() != null)
        .forEach(each -> found.put(each.getName(), about(each)));
    return found;
  }

  /** Returns the type, the unit for the component, the field of the topic, and the description. */
  private static String about(Data value) {
    String own = text(value.getComponentUnit());
    String unit = own.isEmpty() ? text(value.getUnit()) : own;
    String typed = "`" + text(value.getType()) + "`" + (unit.isEmpty() ? "" : " in " + unit);
    String from =
        text(value.getTopicName()).isEmpty()
            ? ""
            : ", `" + text(value.getFieldName()) + "` of `" + value.getTopicName() + "`";
    return (typed + from + "\n\n" + text(value.getDescription())).strip();
  }

  private static String text(String written) {
    return written == null ? "" : written;
  }
}
