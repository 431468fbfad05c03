package dev.eventchain.sandbox;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Checks the text of hand-written Python files, in one confined process, without running any of
 * their code: existing components against their descriptions, and also the modules that they
 * import, and nodes that are hosted as they are, for what makes results differ from run to run.
 *
 * <p>Findings, each with the place in the file: {@code component.syntax}, {@code
 * component.class.missing}, {@code component.constructor.signature}, {@code
 * component.execute.signature}, {@code component.result.keys}, {@code component.result.type},
 * {@code component.node}, {@code component.node.arguments}, {@code component.import.helper}, {@code
 * component.clock}, {@code component.random}, {@code component.thread}; {@code component.ended} if
 * the check itself fails.
 */
public final class SourceCheck {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String PROGRAM = "component_sources.py";
  private static final ConfinedProcess.Limits LIMITS =
      new ConfinedProcess.Limits(Duration.ofMinutes(2), Duration.ofSeconds(30), 512);
  private static final int MAXIMAL_OUTPUT = 16 << 20;

  private final PythonEnvironment environment;

  /**
   * A file to check.
   *
   * @param signature what its node needs; empty for a module that components import
   * @param node the class of a node that is hosted as it is, or an empty name for a module that
   *     such nodes import; empty for anything else
   * @param arguments what the node is made with, by the names of parameters; empty for what its
   *     file says
   */
  public record Source(
      SourceText text,
      Optional<ComponentSignature> signature,
      Optional<String> node,
      Optional<JsonNode> arguments) {

    /** Returns the file of a component, or a module that components import. */
    public static Source of(SourceText text, Optional<ComponentSignature> signature) {
      return new Source(text, signature, Optional.empty(), Optional.empty());
    }

    /** Returns the file of a node that is hosted as it is. */
    public static Source ofNode(SourceText text, String className, Optional<JsonNode> arguments) {
      return new Source(text, Optional.empty(), Optional.of(className), arguments);
    }

    /** Returns a module that nodes import which are hosted as they are. */
    public static Source besideNode(SourceText text) {
      return ofNode(text, "", Optional.empty());
    }
  }

  /** Creates a check on this Python. */
  public SourceCheck(PythonEnvironment environment) {
    this.environment = environment;
  }

  /**
   * Checks files.
   *
   * @return the findings, in the order of the files
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code python.unavailable}: the process
   *     cannot be started
   */
  public List<Diagnostic> check(List<Source> sources) {
    if (sources.isEmpty()) {
      return List.of();
    }
    try (WorkFolder folder = WorkFolder.create()) {
      return check(sources, folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<Diagnostic> check(List<Source> sources, WorkFolder folder) throws IOException {
    var loader = SourceCheck.class.getClassLoader();
    var programs = PythonSources.unpack(loader, "dev/eventchain/sandbox");
    try (ConfinedProcess process =
        ConfinedProcess.on(environment)
            .script(programs.resolve(PROGRAM))
            .pythonPath(programs)
            .workFolder(folder.path())
            .limits(LIMITS)
            .start()) {
      ConfinedProcess.Answer answer = process.ask(request(sources), MAXIMAL_OUTPUT);
      JsonNode found = answer.end().isSuccess() ? read(answer.output()) : JSON.createArrayNode();
      return found.size() == sources.size()
          ? diagnostics(found, sources)
          : List.of(unfinished(sources.get(0), answer.standardError()));
    }
  }

  private static byte[] request(List<Source> sources) throws IOException {
    ObjectNode request = JSON.createObjectNode();
    ArrayNode list = request.putArray("sources");
    for (Source source : sources) {
      ObjectNode entry = list.addObject().put("text", source.text().text());
      source.node().ifPresent(name -> entry.put("node", name));
      source.arguments().ifPresent(given -> entry.set("arguments", given));
      source
          .signature()
          .ifPresent(
              signature -> {
                entry.put("class", signature.className());
                entry.set("inputs", JSON.valueToTree(signature.inputs()));
                entry.set("outputs", JSON.valueToTree(signature.outputs()));
              });
    }
    return JSON.writeValueAsBytes(request);
  }

  private static JsonNode read(String output) {
    try {
      return JSON.readTree(output);
    } catch (JsonProcessingException e) {
      return JSON.createArrayNode(); // incomplete JSON
    }
  }

  private static List<Diagnostic> diagnostics(JsonNode found, List<Source> sources) {
    List<Diagnostic> all = new ArrayList<>();
    for (int i = 0; i < sources.size(); i++) {
      for (JsonNode finding : found.get(i)) {
        all.add(ProbeReport.diagnostic(finding, sources.get(i).text()));
      }
    }
    return all;
  }

  private static Diagnostic unfinished(Source first, String errors) {
    String last = errors.strip();
    return Diagnostic.of(
            ComponentRules.ENDED,
            "The check of the components' source did not end as it should.",
            first.text().at(1, 1))
        .withHint(last.isEmpty() ? "It gave no reason." : "Its last output:\n" + last);
  }
}
