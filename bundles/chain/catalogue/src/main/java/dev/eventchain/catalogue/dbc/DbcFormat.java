package dev.eventchain.catalogue.dbc;

import dev.eventchain.catalogue.dbc.DbcTokens.UnreadException;
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
      Network network = network(text, findings);
      source.node().flatMap(it -> network.withoutNode(it, text.at(0))).ifPresent(findings);
      return new NetworkSignals(network, source.node(), findings).all();
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(findings);
      return List.of();
    }
  }

  /** Reads the statements of a text. */
  static Network network(SourceText text, Consumer<Diagnostic> findings) {
    try {
      Network network = new DbcReader(text, findings).read();
      network.messages().forEach(message -> SharedBits.check(message, findings));
      return network;
    } catch (UnreadException e) {
      findings.accept(Diagnostic.of(CatalogueRules.ENTRY, e.getMessage(), text.at(e.offset())));
      return new Network();
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
