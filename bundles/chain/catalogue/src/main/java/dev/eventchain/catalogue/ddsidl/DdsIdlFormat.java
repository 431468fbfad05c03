package dev.eventchain.catalogue.ddsidl;

import dev.eventchain.catalogue.signal.CatalogueFormat;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;

/**
 * VSS in DDS IDL, as {@code vspec export ddsidl} writes it: a structure for each signal, in modules
 * for the branches. What the export leaves out is not known: meanings of branches, and whether an
 * octet has a sign.
 */
public final class DdsIdlFormat implements CatalogueFormat {

  @Override
  public String prefix() {
    return "vss";
  }

  @Override
  public List<String> suffixes() {
    return List.of(".idl");
  }

  @Override
  public List<CatalogueSignal> read(CatalogueSource source, Consumer<Diagnostic> findings) {
    String hint = "Give them to vspec, or name the catalogue in JSON or YAML.";
    for (Path overlay : source.overlays()) {
      findings.accept(CatalogueRules.noOverlays(overlay, "DDS IDL", hint));
    }
    if (source.node().isPresent()) {
      findings.accept(CatalogueRules.noNode(source, "DDS IDL"));
    }
    try {
      return new IdlModules(SourceText.read(source.file()), findings).read();
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(findings);
      return List.of();
    }
  }
}
