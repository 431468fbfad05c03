package dev.eventchain.contracts;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.ModelChange;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/** Checks that all endpoints use the same unit for a field. */
final class UnitContracts {

  /**
   * The reference for other units.
   *
   * @param name the name of its owner
   */
  private record Reference(String name, String unit, Supplier<SourceLocation> place) {}

  /**
   * Two units of one field that are not the same.
   *
   * @param severity ERROR if one side is wrong; otherwise it may be a matter of writing
   * @param change whether the side that is checked can take the unit of the other one
   */
  private record Clash(Severity severity, String hint, Change change) {}

  /** Change of a unit to that of the other side. */
  private enum Change {
    /** It would be no solution, or a different quantity. */
    NONE,
    /** The code has to follow. */
    WITH_CODE,
    /** Both are the same unit, of which one is misspelt. */
    OF_SPELLING
  }

  private final Findings findings;

  UnitContracts(Findings findings) {
    this.findings = findings;
  }

  /**
   * Checks units against the signal if it gives one, otherwise against the first endpoint that
   * does.
   */
  void check(Topic topic) {
    Map<String, Reference> references = new HashMap<>();
    for (Signal.Field field : topic.signal().map(Signal::fields).orElse(List.of())) {
      if (!field.unit().isBlank()) {
        references.putIfAbsent(
            field.path(), new Reference("the existing signal", field.unit(), field::location));
      }
    }
    topic.publishers().forEach(publisher -> check(topic, publisher, true, references));
    topic.subscribers().forEach(subscriber -> check(topic, subscriber, false, references));
  }

  private void check(
      Topic topic, Endpoint endpoint, boolean writes, Map<String, Reference> references) {
    for (Data data : endpoint.data()) {
      if (data.getUnit() == null || data.getUnit().isBlank() || data.getFieldName() == null) {
        continue;
      }
      Reference reference = references.get(data.getFieldName());
      if (reference == null) {
        references.put(
            data.getFieldName(),
            new Reference(
                endpoint.name(), data.getUnit(), () -> findings.at(data, Literals.DATA__UNIT)));
      } else {
        findings.checked(ContractRule.UNIT_MISMATCH);
        compare(topic, endpoint, data, writes, reference);
      }
    }
  }

  private void compare(
      Topic topic, Endpoint endpoint, Data data, boolean writes, Reference reference) {
    String here = data.getUnit().strip();
    String there = reference.unit().strip();
    Clash clash = clash(here, there, writes).orElse(null);
    if (clash == null) {
      return;
    }
    String message =
        "%s has '%s' of %s in %s, but %s has it in %s."
            .formatted(
                endpoint.name(), data.getFieldName(), topic.name(), here, reference.name(), there);
    SourceLocation at = findings.at(data, Literals.DATA__UNIT);
    String hint = clash.hint() + generated(clash, endpoint, data, here, there);
    Rule rule = ContractRule.UNIT_MISMATCH.rule();
    findings.add(
        new Diagnostic(rule, clash.severity(), message, at, hint, "", List.of())
            .withRelated(reference.place().get())
            .withChanges(changes(clash.change(), at, here, there)));
  }

  /**
   * Returns how the generated node would convert, if there is one that can and does not yet. A
   * language model is shown no sentence that names files, so that prompts do not depend on this
   * one.
   */
  private static String generated(
      Clash clash, Endpoint endpoint, Data data, String here, String there) {
    boolean isConvertible =
        clash.severity() == Severity.ERROR
            && clash.change() == Change.WITH_CODE
            && endpoint.node().getImplementation() == ComponentImplementation.COMPONENT
            && data.getType() != null
            && data.getType().matches(FieldType.NUMBER);
    return isConvertible && data.getComponentUnit() == null
        ? " Or let the generated node convert: unit '%s' and component_unit '%s' in chain.json and components.json (unit and componentUnit in a model)."
            .formatted(there, here)
        : "";
  }

  private static List<ModelChange> changes(
      Change change, SourceLocation at, String here, String there) {
    if (change == Change.NONE) {
      return List.of();
    }
    boolean certain = change == Change.OF_SPELLING;
    String title =
        "Change the unit to '%s'%s"
            .formatted(there, certain ? "" : ", which the component's code must follow");
    String unit = Literals.DATA__UNIT.getName();
    return List.of(new ModelChange(title, at, "", unit, here, there, certain));
  }

  /** Returns in what two units clash, if they do; for the side that has the first one. */
  private static Optional<Clash> clash(String here, String there, boolean writes) {
    if (here.equals(there)) {
      return Optional.empty();
    }
    Optional<Unit> unit = Unit.parse(here);
    Optional<Unit> other = Unit.parse(there);
    if (unit.isEmpty() || other.isEmpty()) {
      String hint =
          "'%s' is not a known unit, such as m/s2, km/h, deg, %%: write the same on both sides."
              .formatted(unit.isEmpty() ? here : there);
      return Optional.of(new Clash(Severity.WARNING, hint, respelling(here, other)));
    }
    return clash(unit.get(), other.get(), there, writes);
  }

  private static Optional<Clash> clash(Unit unit, Unit other, String there, boolean writes) {
    return switch (unit.relationTo(other)) {
      case SAME -> Optional.empty();
      case ANGLE ->
          Optional.of(
              new Clash(
                  Severity.WARNING,
                  "One side is an angle and the other is not: write the intended unit on both.",
                  Change.NONE));
      case INCOMPATIBLE ->
          Optional.of(
              new Clash(
                  Severity.ERROR,
                  "No factor converts one into the other: one side is a different quantity.",
                  Change.NONE));
      case CONVERTIBLE ->
          Optional.of(
              new Clash(Severity.ERROR, conversion(unit, other, there, writes), Change.WITH_CODE));
    };
  }

  /**
   * Returns the change of an unknown unit to that of the other side, if that is known. Similar
   * texts are no evidence that both are the same: "f/s" is one letter from "m/s".
   */
  private static Change respelling(String here, Optional<Unit> other) {
    if (other.isEmpty() || Unit.parse(here).isPresent()) {
      return Change.NONE;
    }
    boolean isSame =
        Unit.respelled(here)
            .flatMap(Unit::parse)
            .filter(unit -> unit.relationTo(other.get()) == Unit.Relation.SAME)
            .isPresent();
    return isSame ? Change.OF_SPELLING : Change.WITH_CODE;
  }

  private static String conversion(Unit here, Unit there, String name, boolean writes) {
    return writes
        ? "Give it in %s: %s.".formatted(name, here.conversionTo(there))
        : "Take it in %s, and convert inside the component: %s."
            .formatted(name, there.conversionTo(here));
  }
}
