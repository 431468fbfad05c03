package dev.eventchain.eclipse;

import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.Requirements;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;

/**
 * The model of an event chain that was described in JSON by a person or a language model.
 *
 * @param model the bytes of the {@code .xmi} file
 * @param diagnostics warnings about the description
 */
public record ChainImport(byte[] model, List<Diagnostic> diagnostics) {

  /**
   * Reads a description.
   *
   * @param description the JSON file
   * @param name the name of the chain
   * @param requirements the Markdown file with the requirements that it may name; need not exist
   * @param frequency Hz, for components whose description gives none; empty leaves it unset
   * @throws DiagnosticException INPUT if a file cannot be read, FINDINGS if the description has
   *     errors
   */
  public static ChainImport read(
      Path description, String name, Path requirements, OptionalDouble frequency) {
    Requirements written =
        Files.isRegularFile(requirements)
            ? Requirements.read(SourceText.read(requirements))
            : new Requirements(List.of(), List.of());
    Modeled<EventChain> read =
        EventChainReader.read(SourceText.read(description), name, written.items(), frequency);
    if (Diagnostic.anyError(read.diagnostics())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, read.diagnostics());
    }
    return new ChainImport(XmiStore.toBytes(read.root()), read.diagnostics());
  }
}
