package dev.eventchain.pipeline.generate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.UnitConversion;
import dev.eventchain.model.ComponentUnits;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.stage.ChainSnapshot;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Conversions of units in generated nodes. */
final class UnitConversions {

  private UnitConversions() {}

  /**
   * Returns template properties: for each pair of units, in both directions, the operators that
   * convert one into the other.
   */
  static Map<String, String> properties(EventChain chain) {
    Map<String, String> properties = new TreeMap<>();
    for (Data data : chain.getData()) {
      if (ComponentUnits.isConverted(data)) {
        add(properties, ComponentUnits.onTheWire(data), ComponentUnits.of(data));
        add(properties, ComponentUnits.of(data), ComponentUnits.onTheWire(data));
      }
    }
    return properties;
  }

  private static void add(Map<String, String> properties, String from, String to) {
    UnitConversion.between(from, to)
        .ifPresent(it -> properties.put("conversion." + from + ">" + to, it.operators()));
  }

  /**
   * Checks that generated nodes convert: without that, values would be wrong by a factor.
   *
   * @param generated empty if the templates write no manifest, which would say so
   * @return a warning for each value of which it is not known
   * @throws DiagnosticException INPUT, {@code simulation.manifest}, if some are not converted
   */
  static List<Diagnostic> check(ChainSnapshot model, Optional<GeneratedPackage> generated) {
    List<Diagnostic> found =
        model.chain().getSoftware().stream()
            .filter(node -> node.getImplementation() == ComponentImplementation.COMPONENT)
            .flatMap(
                node ->
                    generated
                        .map(each -> each.manifest().unconverted(node).stream())
                        .orElseGet(() -> unproved(model, node)))
            .toList();
    if (Diagnostic.anyError(found)) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, found);
    }
    return found;
  }

  private static Stream<Diagnostic> unproved(ChainSnapshot model, SoftwareNode node) {
    return Stream.concat(node.getInput().stream(), node.getOutput().stream())
        .filter(ComponentUnits::isConverted)
        .map(
            data ->
                Diagnostic.of(
                        GenerateRules.UNIT_UNCONVERTED,
                        "The templates write no manifest, so it is not known whether the node of '%s' converts '%s' between %s and %s."
                            .formatted(
                                node.getName(),
                                data.getName(),
                                ComponentUnits.onTheWire(data),
                                ComponentUnits.of(data)),
                        model.locate(data))
                    .withHint(
                        "Convert with python::units, and say so by [chain.manifestFile(true)/] of python::manifest."));
  }
}
