package dev.eventchain.sandbox;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Lists the mutants of a component: small defects, one in each place where an operator applies. The
 * component is parsed by a confined process; nothing of it is run.
 */
public final class ComponentMutator {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final Duration LONGEST = Duration.ofMinutes(2);
  private static final int MEMORY_MIB = 512;
  private static final int MOST_OUTPUT = 64 << 20;

  private final PythonEnvironment environment;

  public ComponentMutator(PythonEnvironment environment) {
    this.environment = environment;
  }

  /**
   * Two parameters of {@code execute} that mean the same kind of thing, so may be mixed up.
   *
   * @param isBoolean whether both are true or false
   */
  public record Pair(String first, String second, boolean isBoolean) {}

  /**
   * An output of a component.
   *
   * @param single false if it is an array
   */
  public record Output(String name, boolean single) {}

  /**
   * Returns the mutants of a component, in the order of their places.
   *
   * @param source its file
   * @throws DiagnosticException FINDINGS, {@code component.syntax}: it cannot be parsed
   */
  public List<ComponentMutant> mutants(
      SourceText source, String className, List<Pair> swaps, List<Output> outputs) {
    return mutants(source, request(source, className, swaps, outputs));
  }

  /**
   * Returns the mutants of a node that is hosted as it is, in the order of their places: of its
   * class, and of what that reaches in its file, without what creates its endpoints and timers.
   *
   * @param source its file
   * @throws DiagnosticException FINDINGS, {@code component.syntax}: it cannot be parsed
   */
  public List<ComponentMutant> ofNode(SourceText source, String className) {
    return mutants(source, request(source, className, List.of(), List.of()).put("node", true));
  }

  /**
   * Returns the mutants of a module that components or nodes import, in the order of their places:
   * of what these name in it, and of what that reaches in its file, without what creates endpoints
   * and timers.
   *
   * @param source its file
   * @param importers the texts of the files that may import it
   * @throws DiagnosticException FINDINGS, {@code component.syntax}: it cannot be parsed
   */
  public List<ComponentMutant> ofModule(SourceText source, Collection<String> importers) {
    ObjectNode request = request(source, "", List.of(), List.of());
    ArrayNode texts = request.putArray("importers");
    importers.forEach(texts::add);
    return mutants(source, request);
  }

  private List<ComponentMutant> mutants(SourceText source, ObjectNode request) {
    JsonNode answer = ask(request.toString().getBytes(StandardCharsets.UTF_8));
    if (!answer.path("mutants").isArray()) {
      String problem = answer.path("problem").asText("the process that parses it has ended");
      throw new DiagnosticException(
          DiagnosticException.Reason.FINDINGS,
          Diagnostic.of(
              ComponentRules.SYNTAX,
              "It cannot be parsed: " + Printable.line(problem) + ".",
              source.at(0)));
    }
    Map<String, Integer> seen = new HashMap<>();
    List<ComponentMutant> mutants = new ArrayList<>();
    answer.path("mutants").forEach(each -> mutants.add(mutant(each, seen)));
    return mutants;
  }

  private static ComponentMutant mutant(JsonNode json, Map<String, Integer> seen) {
    String operator = json.path("operator").asText();
    String function = json.path("function").asText();
    String before = json.path("before").asText();
    String after = json.path("after").asText();
    List<ComponentMutant.Edit> edits = new ArrayList<>();
    for (JsonNode edit : json.path("edits")) {
      edits.add(
          new ComponentMutant.Edit(edit.get(0).asInt(), edit.get(1).asInt(), edit.get(2).asText()));
    }
    int number =
        seen.merge(ComponentMutant.id(operator, function, before, after, 1), 1, Integer::sum);
    return new ComponentMutant(
        ComponentMutant.id(operator, function, before, after, number),
        operator,
        json.path("line").asInt(),
        json.path("column").asInt(),
        before,
        after,
        edits);
  }

  private static ObjectNode request(
      SourceText source, String className, List<Pair> swaps, List<Output> outputs) {
    ObjectNode request = JSON.createObjectNode();
    request.put("source", source.text());
    request.put("class", className);
    ArrayNode pairs = request.putArray("swaps");
    swaps.forEach(
        pair -> pairs.addArray().add(pair.first()).add(pair.second()).add(pair.isBoolean()));
    ArrayNode written = request.putArray("outputs");
    outputs.forEach(output -> written.addArray().add(output.name()).add(output.single()));
    return request;
  }

  /** Returns the answer of the process; null if it gave none. */
  private JsonNode ask(byte[] request) {
    Path sources = PythonSources.unpack(getClass().getClassLoader(), "dev/eventchain/sandbox");
    try (WorkFolder folder = WorkFolder.create();
        ConfinedProcess process =
            ConfinedProcess.on(environment)
                .script(sources.resolve("component_mutants.py"))
                .pythonPath(sources)
                .workFolder(folder.path())
                .limits(new ConfinedProcess.Limits(LONGEST, LONGEST, MEMORY_MIB))
                .start()) {
      return JSON.readTree(process.ask(request, MOST_OUTPUT).output());
    } catch (JsonProcessingException e) {
      return JSON.createObjectNode();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
