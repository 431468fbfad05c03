package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.network.Network;
import dev.eventchain.catalogue.network.NetworkSignals;
import dev.eventchain.catalogue.network.SharedBits;
import dev.eventchain.catalogue.signal.CatalogueFormat;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.XmlElement;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A network on CAN in a system description of AUTOSAR 4 (ARXML), whose packages may go on in
 * further files.
 */
public final class ArxmlFormat implements CatalogueFormat {

  private static final String SUFFIX = ".arxml";
  private static final String SCHEMA = "http://autosar.org/schema/r4.0";

  @Override
  public String prefix() {
    return "can";
  }

  @Override
  public List<String> suffixes() {
    return List.of(SUFFIX);
  }

  @Override
  public List<CatalogueSignal> read(CatalogueSource source, Consumer<Diagnostic> findings) {
    try {
      Network network = network(source.files(), findings);
      SourceLocation place = SourceLocation.of(source.file());
      source.node().flatMap(it -> problem(it, network, place)).ifPresent(findings);
      return new NetworkSignals(network, source.node(), findings).all();
    } catch (ArxmlPdus.TooManyException e) {
      findings.accept(
          Diagnostic.of(CatalogueRules.SIZE, e.getMessage(), SourceLocation.of(source.file())));
      return List.of();
    }
  }

  /** Reads the network that files describe together. */
  static Network network(List<Path> files, Consumer<Diagnostic> findings) {
    ArxmlTree tree = new ArxmlTree(findings);
    for (Path file : files) {
      root(file, findings).ifPresent(tree::add);
    }
    Network network = new ArxmlReader(tree, findings).read();
    network.messages().forEach(message -> SharedBits.check(message, findings));
    return network;
  }

  /** Returns a finding about a node that the network does not have, or of which it says nothing. */
  private static Optional<Diagnostic> problem(String node, Network network, SourceLocation place) {
    boolean silent =
        network.nodes().contains(node)
            && network.messages().stream().allMatch(it -> it.senders().isEmpty());
    return silent
        ? Optional.of(
            Diagnostic.of(
                    CatalogueRules.NODE,
                    "No message says who sends it, so '" + node + "' would send nothing.",
                    place)
                .withHint("Frames, PDUs or signals refer to the ports of ECUs."))
        : network.withoutNode(node, place);
  }

  private static Optional<XmlElement> root(Path file, Consumer<Diagnostic> findings) {
    if (!file.toString().toLowerCase(Locale.ROOT).endsWith(SUFFIX)) {
      findings.accept(
          Diagnostic.of(
              CatalogueRules.OVERLAY,
              "An overlay of a catalogue in ARXML is another file in ARXML.",
              SourceLocation.of(file)));
      return Optional.empty();
    }
    try {
      XmlElement root = XmlElement.parse(SourceText.read(file), CatalogueRules.ENTRY);
      String schema = root.attribute("xsi:schemaLocation").orElse(SCHEMA);
      if (ArxmlElement.local(root).equals("AUTOSAR") && schema.contains(SCHEMA)) {
        return Optional.of(root);
      }
      findings.accept(
          Diagnostic.of(
                  CatalogueRules.ENTRY, "This is no description in AUTOSAR 4.", root.location())
              .withHint("Its root is AUTOSAR, of the schema " + SCHEMA + "."));
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(findings);
    }
    return Optional.empty();
  }
}
