package dev.eventchain.python;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * The part of a {@link ComponentProbe} that only reads: whether generated components keep to what
 * they may import, use and define. Nothing of them runs, so it is cheap enough to be asked each
 * time before they do.
 */
public final class ComponentRules {

  /** A component file, and what it has to look like. */
  public record Candidate(Path file, ComponentSignature signature) {}

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final int MEMORY_MIB = 512;

  private final PythonEnvironment environment;

  /** Reads with the parser of this Python. */
  public ComponentRules(PythonEnvironment environment) {
    this.environment = environment;
  }

  /**
   * Checks files, all in one process.
   *
   * @return what is wrong, by file and place; empty if nothing is
   * @throws dev.eventchain.diagnostics.DiagnosticException a file is missing or no UTF-8 text, or
   *     there is no Python
   * @throws IllegalStateException the process did not answer for each file
   */
  public List<Diagnostic> check(List<Candidate> candidates) {
    if (candidates.isEmpty()) {
      return List.of();
    }
    List<SourceText> sources =
        candidates.stream().map(candidate -> SourceText.read(candidate.file())).toList();
    JsonNode answer = run(candidates);
    if (!answer.isArray() || answer.size() != candidates.size()) {
      throw new IllegalStateException("component_rules.py did not answer for each file");
    }
    List<Diagnostic> found = new ArrayList<>();
    for (int i = 0; i < sources.size(); i++) {
      for (JsonNode finding : answer.get(i)) {
        found.add(ProbeReport.diagnostic(finding, sources.get(i)));
      }
    }
    return found.stream().sorted().toList();
  }

  private JsonNode run(List<Candidate> candidates) {
    Path sources = PythonSources.unpack(getClass().getClassLoader(), "dev/eventchain/python");
    try (WorkFolder folder = WorkFolder.create();
        ConfinedProcess process =
            ConfinedProcess.on(environment)
                .script(sources.resolve("component_rules.py"))
                .pythonPath(sources)
                .readable(candidates.stream().map(Candidate::file).toArray(Path[]::new))
                .workFolder(folder.path())
                .limits(new ConfinedProcess.Limits(LIMIT, LIMIT, MEMORY_MIB))
                .start()) {
      try (OutputStream input = process.stdin()) {
        input.write(JSON.writeValueAsBytes(request(candidates)));
      }
      byte[] output = process.stdout().readAllBytes();
      ConfinedProcess.Termination end = process.await();
      if (!end.isSuccess()) {
        throw new IllegalStateException(
            "component_rules.py ended with " + end.exitCode() + ": " + process.standardError());
      }
      return JSON.readTree(output);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static ArrayNode request(List<Candidate> candidates) {
    ArrayNode request = JSON.createArrayNode();
    for (Candidate candidate : candidates) {
      ComponentSignature signature = candidate.signature();
      ObjectNode entry = request.addObject();
      entry.put("file", candidate.file().toAbsolutePath().normalize().toString());
      entry.put("class", signature.className());
      entry.set("inputs", JSON.valueToTree(signature.inputs()));
      entry.set("outputs", JSON.valueToTree(signature.outputs()));
    }
    return request;
  }
}
