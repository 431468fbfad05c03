package dev.eventchain.contracts;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.ComponentUnits;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.util.Optional;

/**
 * Checks that a generated node can convert each value whose unit in the component is not that of
 * the message.
 */
final class ConversionContracts {

  /** A reason why nothing converts, and what to do. */
  private record Problem(String why, String hint) {}

  private final TypeContracts types;
  private final Findings findings;

  ConversionContracts(TypeContracts types, Findings findings) {
    this.types = types;
    this.findings = findings;
  }

  void check(Topic topic) {
    for (Endpoint endpoint : topic.endpoints()) {
      endpoint.data().stream()
          .filter(ComponentUnits::isConverted)
          .forEach(data -> check(topic, endpoint, data));
    }
  }

  private void check(Topic topic, Endpoint endpoint, Data data) {
    findings.checked(ContractRule.UNIT_UNCONVERTED);
    Optional<Problem> problem =
        unconverted(endpoint).or(() -> ofType(data)).or(() -> ofUnits(data));
    if (problem.isPresent()) {
      SourceLocation at = findings.at(data, Literals.DATA__COMPONENT_UNIT);
      findings.error(
          ContractRule.UNIT_UNCONVERTED,
          at,
          "'%s' of %s is to be in %s within %s, but nothing converts it: %s."
              .formatted(
                  data.getFieldName(),
                  topic.name(),
                  ComponentUnits.of(data),
                  endpoint.name(),
                  problem.get().why()),
          problem.get().hint());
    }
  }

  private static Optional<Problem> unconverted(Endpoint endpoint) {
    return endpoint.node().getImplementation() == ComponentImplementation.NODE
        ? Optional.of(
            new Problem(
                "it is a node by itself, around which none is generated",
                "Convert inside the node, and leave the unit of the component out."))
        : Optional.empty();
  }

  private Optional<Problem> ofType(Data data) {
    if (data.getType() == null || data.getType().isBlank()) {
      return Optional.of(
          new Problem("its type is not stated", "State the type of the field, such as float32."));
    }
    return types
        .fieldType(data)
        .filter(type -> !type.toString().matches(FieldType.NUMBER))
        .map(
            type ->
                new Problem(
                    "it is no single number, but %s".formatted(type),
                    "Convert inside the component, and leave its unit out."));
  }

  private static Optional<Problem> ofUnits(Data data) {
    String wire = ComponentUnits.onTheWire(data);
    String own = ComponentUnits.of(data);
    if (wire.isEmpty()) {
      return Optional.of(
          new Problem("its unit in messages is not stated", "State that unit, too."));
    }
    for (String unit : new String[] {wire, own}) {
      if (Unit.parse(unit).isEmpty()) {
        return Optional.of(
            new Problem(
                "'%s' is not a known unit".formatted(unit),
                "Write units as in m/s2, km/h, deg or %."));
      }
    }
    return switch (Unit.parse(wire).get().relationTo(Unit.parse(own).get())) {
      case SAME, CONVERTIBLE -> Optional.empty();
      case ANGLE ->
          Optional.of(
              new Problem(
                  "one of %s and %s is an angle and the other is not".formatted(wire, own),
                  "Write the intended unit on both sides."));
      case INCOMPATIBLE ->
          Optional.of(
              new Problem(
                  "no factor converts %s into it".formatted(wire),
                  "One of the units is that of a different quantity."));
    };
  }
}
