package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.Diagnosis.Part;
import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.agents.prompt.RuleText;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.Requirements;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Finds out which part of a system is wrong that failed in the simulation. */
public final class DiagnoseAgent {
  private static final PromptTemplate PROMPT = PromptTemplate.load("diagnose/v1");
  private static final String FILE = "diagnosis.json";

  private final AgentContext context;

  /** Creates an agent for a context. */
  public DiagnoseAgent(AgentContext context) {
    this.context = context;
  }

  /**
   * A system that failed.
   *
   * @param chain the event-chain description
   * @param path the components on the way to what failed
   * @param written those of them that a language model wrote, which can be corrected
   * @param code their code and tests, for the prompt
   * @param verdict what failed, with the signals on the way to it
   * @param tried the diagnoses before, which did not help
   */
  public record Failure(
      SourceText chain,
      List<String> path,
      List<String> written,
      String code,
      String verdict,
      List<Diagnosis> tried) {
    /** Copies the lists. */
    public Failure {
      path = List.copyOf(path);
      written = List.copyOf(written);
      tried = List.copyOf(tried);
    }
  }

  /**
   * Asks what is wrong.
   *
   * @param requirements the functional requirements
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS if no answer passed its checks;
   *     and as the model throws
   */
  public Diagnosis diagnose(Failure failure, Requirements requirements) {
    String design =
        failure.path().stream()
            .map(name -> NotAsked.without(ChainView.component(failure.chain(), name).json()))
            .map(JsonLayout::compact)
            .collect(Collectors.joining(",\n", "[\n", "\n]"));
    Map<String, String> values =
        Map.of(
            "verdict", failure.verdict(),
            "requirements", RuleText.items(requirements.items()),
            "design", design,
            "code", failure.code(),
            "tried", tried(failure.tried()),
            "written", failure.written().isEmpty() ? "none" : String.join(", ", failure.written()));
    AgentResult result =
        new RepairLoop(context, "diagnose", AnswerKind.JSON)
            .run(
                FILE,
                PROMPT,
                values,
                Optional.empty(),
                text -> check(text, failure.written(), requirements));
    return read(JsonDocument.parse(SourceText.of(FILE, result.text())).root());
  }

  private static String tried(List<Diagnosis> before) {
    if (before.isEmpty()) {
      return "Nothing.";
    }
    return before.stream()
        .map(
            each ->
                "- %s `%s`: %s It was corrected, or its author found no fault in it, and the"
                        .formatted(words(each.wrong()), each.name(), each.why())
                    + " simulation still failed.")
        .collect(Collectors.joining("\n"));
  }

  private static Diagnosis read(JsonNode json) {
    return new Diagnosis(
        part(json.path("wrong").asText()).orElseThrow(),
        json.path("name").asText(),
        json.path("why").asText().strip());
  }

  private static String words(Part part) {
    return part.name().toLowerCase(Locale.ROOT);
  }

  private static Optional<Part> part(String word) {
    return Arrays.stream(Part.values()).filter(each -> words(each).equals(word)).findFirst();
  }

  static List<Diagnostic> check(SourceText text, List<String> written, Requirements requirements) {
    Document document = JsonDocument.parse(text);
    JsonNode json = document.root();
    List<Diagnostic> found = new ArrayList<>();
    Optional<Part> part = part(json.path("wrong").asText());
    if (part.isEmpty()) {
      String kinds =
          Arrays.stream(Part.values()).map(DiagnoseAgent::words).collect(Collectors.joining(", "));
      found.add(wrong(document, "/wrong", "'wrong' is one of " + kinds + ".", ""));
    }
    if (json.path("why").asText().isBlank()) {
      found.add(wrong(document, "/why", "'why' says nothing.", ""));
    }
    String name = json.path("name").asText();
    List<String> names = part.map(it -> names(it, written, requirements)).orElse(List.of());
    boolean needed = part.isPresent() && part.get() != Part.DESIGN;
    if (needed && !names.contains(name)) {
      String message =
          "'name' is '%s', which cannot be corrected as %s.".formatted(name, words(part.get()));
      String all =
          names.isEmpty() ? "There is none." : "It is one of " + String.join(", ", names) + ".";
      found.add(wrong(document, "/name", message, NearestName.question(name, names) + " " + all));
    }
    return found;
  }

  private static List<String> names(Part part, List<String> written, Requirements requirements) {
    return part == Part.REQUIREMENT
        ? requirements.items().stream().map(WrittenRequirement::id).toList()
        : written;
  }

  private static Diagnostic wrong(Document document, String pointer, String message, String hint) {
    return Diagnostic.of(AgentRules.DIAGNOSIS, message, document.at(pointer))
        .withHint(hint.strip());
  }
}
