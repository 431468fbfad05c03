package dev.eventchain.catalogue.dbc;

import dev.eventchain.catalogue.dbc.DbcTokens.UnreadException;
import dev.eventchain.catalogue.signal.CatalogueFormat;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;

/**
 * A network of a vehicle in DBC: its messages on CAN, with their signals. Written in UTF-8, or in
 * Windows-1252 as the tools of the format write it.
 */
public final class DbcFormat implements CatalogueFormat {

  private static final Charset WINDOWS = Charset.forName("windows-1252");

  @Override
  public String prefix() {
    return "can";
  }

  @Override
  public List<String> suffixes() {
    return List.of(".dbc");
  }

  @Override
  public List<CatalogueSignal> read(CatalogueSource source, Consumer<Diagnostic> findings) {
    String hint = "Merge the networks with the tool that writes them.";
    for (Path overlay : source.overlays()) {
      findings.accept(CatalogueRules.noOverlays(overlay, "DBC", hint));
    }
    try {
      SourceText text = text(source.file());
      DbcNetwork network = network(text, findings);
      source.node().ifPresent(node -> checkNode(node, network, text, findings));
      return new DbcSignals(network, source.node(), findings).all();
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(findings);
      return List.of();
    }
  }

  /** Reads the statements of a text. */
  static DbcNetwork network(SourceText text, Consumer<Diagnostic> findings) {
    try {
      DbcNetwork network = new DbcReader(text, findings).read();
      network.messages().forEach(message -> DbcOverlaps.check(message, findings));
      return network;
    } catch (UnreadException e) {
      findings.accept(Diagnostic.of(CatalogueRules.ENTRY, e.getMessage(), text.at(e.offset())));
      return new DbcNetwork();
    }
  }

  private static void checkNode(
      String node, DbcNetwork network, SourceText text, Consumer<Diagnostic> findings) {
    if (!network.nodes().contains(node)) {
      findings.accept(
          Diagnostic.of(CatalogueRules.NODE, "The network has no node '" + node + "'.", text.at(0))
              .withHint(NearestName.hint(node, network.nodes())));
    }
  }

  private static SourceText text(Path file) {
    try {
      return SourceText.read(file);
    } catch (DiagnosticException e) {
      boolean encoding = e.diagnostics().stream().anyMatch(it -> it.id().equals("file.encoding"));
      if (!encoding) {
        throw e;
      }
      return windows(file, e);
    }
  }

  private static SourceText windows(Path file, DiagnosticException otherwise) {
    try {
      String text = new String(Files.readAllBytes(file), WINDOWS);
      if (text.indexOf('\0') < 0) {
        return SourceText.of(SourceLocation.of(file).file(), text);
      }
    } catch (IOException e) {
      // It was read a moment ago; what was said of it then holds.
    }
    throw otherwise;
  }
}
