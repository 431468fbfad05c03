package dev.eventchain.catalogue.vss;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSignal.Role;
import dev.eventchain.catalogue.signal.CatalogueUnits;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;

/** Reads the signals of an expanded tree. */
final class VssLeaves {

  private static final String TYPE = "type";
  private static final String DATATYPE = "datatype";
  private static final String DESCRIPTION = "description";
  private static final String BRANCH = "branch";

  private static final Map<String, Role> ROLES =
      Map.of("sensor", Role.SENSOR, "actuator", Role.ACTUATOR, "attribute", Role.ATTRIBUTE);

  /** Structures and their members, which are no signals. */
  private static final Set<String> PARTS_OF_TYPES = Set.of("struct", "property");

  private static final List<String> TYPES =
      List.of(BRANCH, "sensor", "actuator", "attribute", "struct", "property");

  private static final Map<String, String> DATATYPES =
      Map.ofEntries(
          Map.entry("boolean", "bool"),
          Map.entry("string", "string"),
          Map.entry("float", "float32"),
          Map.entry("double", "float64"),
          Map.entry("int8", "int8"),
          Map.entry("int16", "int16"),
          Map.entry("int32", "int32"),
          Map.entry("int64", "int64"),
          Map.entry("uint8", "uint8"),
          Map.entry("uint16", "uint16"),
          Map.entry("uint32", "uint32"),
          Map.entry("uint64", "uint64"));

  private static final Set<String> NO_NUMBERS = Set.of("boolean", "string");

  /** Attributes of the standard; others are extensions, unless they resemble one of these. */
  private static final List<String> ATTRIBUTES =
      List.of(
          TYPE,
          DATATYPE,
          DESCRIPTION,
          "unit",
          "min",
          "max",
          "allowed",
          "enum",
          "default",
          "comment",
          "deprecation",
          "instances",
          "instances_relation",
          "instantiate",
          "aggregate",
          "arraysize",
          "pattern",
          "delete",
          "constUID",
          "fka");

  private final Set<String> structures;
  private final Consumer<Diagnostic> findings;

  /**
   * Creates a reader.
   *
   * @param structures the paths of the structures that types may name
   */
  VssLeaves(Set<String> structures, Consumer<Diagnostic> findings) {
    this.structures = structures;
    this.findings = findings;
  }

  /** Adds the signals at and below a node. */
  void read(VssNode node, String above, List<String> groups, List<CatalogueSignal> signals) {
    if (node.is("delete", true)) {
      return;
    }
    String path = above.isEmpty() ? node.name() : above + "." + node.name();
    if (!node.name().matches("[A-Za-z][A-Za-z0-9_]*")) {
      String message = "'" + node.name() + "' cannot be a part of a topic's name.";
      find(message, node.location(), "Use letters, digits and underscores, a letter first.");
      return;
    }
    node.attributes().forEach(this::checkAttribute);
    String type = node.text(TYPE);
    boolean branch = type.equals(BRANCH) || (type.isEmpty() && !node.children().isEmpty());
    if (branch) {
      List<String> all = new ArrayList<>(groups);
      Optional.of(node.text(DESCRIPTION)).filter(it -> !it.isBlank()).ifPresent(all::add);
      node.children().values().forEach(child -> read(child, path, all, signals));
    } else if (!ROLES.containsKey(type)) {
      checkType(node, path, type);
    } else if (!node.children().isEmpty()) {
      String message = "'" + path + "' is a signal, but there are entries below it.";
      find(message, node.location(), "Only a branch has entries below it.");
    } else {
      signal(node, path, ROLES.get(type), groups).ifPresent(signals::add);
    }
  }

  private void checkAttribute(String name, VssValue value) {
    Optional<String> meant =
        ATTRIBUTES.contains(name) ? Optional.empty() : NearestName.of(name, ATTRIBUTES);
    meant.ifPresent(
        known ->
            findings.accept(
                Diagnostic.of(
                        CatalogueRules.ATTRIBUTE,
                        "The attribute '" + name + "' is not read.",
                        value.key())
                    .withHint("Did you mean `" + known + "`?")));
  }

  private void checkType(VssNode node, String path, String type) {
    if (!PARTS_OF_TYPES.contains(type)) {
      String message =
          type.isEmpty()
              ? "'" + path + "' has no type."
              : "'" + type + "' is not the type of a signal or branch.";
      SourceLocation place = node.value(TYPE).map(VssValue::location).orElse(node.location());
      find(message, place, NearestName.hint(type, TYPES));
    }
  }

  private Optional<CatalogueSignal> signal(
      VssNode node, String path, Role role, List<String> groups) {
    String datatype = node.text(DATATYPE);
    String element = datatype.replaceFirst("\\[]$", "");
    if (!DATATYPES.containsKey(element) && !isStructure(element)) {
      refuseDatatype(node, path, datatype);
      return Optional.empty();
    }
    OptionalDouble least = number(node, "min");
    OptionalDouble most = number(node, "max");
    if (least.orElse(Double.NEGATIVE_INFINITY) > most.orElse(Double.POSITIVE_INFINITY)) {
      String message = "The range of '" + path + "' ends before it begins.";
      find(message, node.location(), "");
    }
    VssValues values =
        VssValues.of(node, element.equals("string"), (message, at) -> find(message, at, ""));
    return Optional.of(
        new CatalogueSignal(
            path,
            role,
            type(datatype, element),
            CatalogueUnits.of(node.text("unit")),
            least,
            most,
            values.texts(),
            element.equals(datatype) ? values.names() : List.of(),
            node.text(DESCRIPTION),
            groups,
            node.location()));
  }

  private void refuseDatatype(VssNode node, String path, String datatype) {
    String message =
        datatype.isEmpty()
            ? "'" + path + "' has no datatype."
            : "'" + datatype + "' is not a datatype.";
    SourceLocation place = node.value(DATATYPE).map(VssValue::location).orElse(node.location());
    find(message, place, NearestName.hint(datatype, DATATYPES.keySet()));
  }

  private boolean isStructure(String datatype) {
    return structures.stream()
        .anyMatch(known -> known.equals(datatype) || known.endsWith("." + datatype));
  }

  /** Returns the type in a message; lists of texts and truth values, and structures, have none. */
  private static Optional<String> type(String datatype, String element) {
    boolean list = !element.equals(datatype);
    return Optional.ofNullable(DATATYPES.get(element))
        .filter(type -> !list || !NO_NUMBERS.contains(element))
        .map(type -> list ? type + "[]" : type);
  }

  private OptionalDouble number(VssNode node, String attribute) {
    Optional<VssValue> value = node.value(attribute);
    if (value.isEmpty()) {
      return OptionalDouble.empty();
    }
    if (!value.get().json().isNumber()) {
      find("'" + attribute + "' must be a number.", value.get().location(), "");
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(value.get().json().doubleValue());
  }

  private void find(String message, SourceLocation place, String hint) {
    Diagnostic finding = Diagnostic.of(CatalogueRules.ENTRY, message, place);
    findings.accept(hint.isEmpty() ? finding : finding.withHint(hint));
  }
}
