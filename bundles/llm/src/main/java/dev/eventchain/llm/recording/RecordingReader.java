package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ChatResponse.Usage;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Strict reader of recordings: reports every deviation from the format with its line and column.
 */
final class RecordingReader {

  private static final Rule FORMAT = RecordingRules.RECORDING_FORMAT;
  private static final Rule JSON = RecordingRules.RECORDING_JSON;
  private static final DocumentRules RULES =
      new DocumentRules(JSON, JSON, FORMAT, FORMAT, FORMAT, FORMAT);
  private static final NumberRange TOKENS = NumberRange.of(0, 1L << 52);

  private final SourceText source;
  private final List<Diagnostic> problems = new ArrayList<>();

  private RecordingReader(SourceText source) {
    this.source = source;
  }

  /**
   * Reads a file of format {@code llm-recording/1}.
   *
   * @throws DiagnosticException INPUT with every problem found
   */
  static Recording read(Path file) {
    try {
      return new RecordingReader(SourceText.read(file)).read();
    } catch (DiagnosticException e) {
      throw new DiagnosticException(
          e.reason(), e.diagnostics().stream().map(RecordingReader::hinted).toList());
    }
  }

  private static Diagnostic hinted(Diagnostic problem) {
    return problem.withHint("Restore the recording, or delete it and record it again.");
  }

  private Recording read() {
    // Answers are recorded verbatim, including control characters.
    Document document =
        Document.parseWithAnyText(source, DocumentFormat.JSON, RULES, problems::add);
    Optional<ObjectReader> root = document.object("", problems::add);
    stopOnProblems();
    List<Recording.Sample> samples = recording(root.orElseThrow());
    stopOnProblems();
    ObjectNode request = RequestJson.withTexts((ObjectNode) document.root().get("request"));
    RequestKey key = RequestKey.of(request);
    if (!document.root().get("key").asText().equals(key.value())) {
      String message = "The key does not belong to this request, whose key is " + key.value() + ".";
      problems.add(Diagnostic.of(RecordingRules.RECORDING_KEY, message, document.at("/key")));
    }
    stopOnProblems();
    return new Recording(key, request, samples);
  }

  private List<Recording.Sample> recording(ObjectReader json) {
    String format = json.requiredText("format");
    if (json.has("format") && !format.equals(RecordingWriter.FORMAT)) {
      json.find(FORMAT, "The format is not " + RecordingWriter.FORMAT + ".", json.at("format"));
    }
    json.requiredText("key");
    json.requiredObject("request").ifPresent(RecordingReader::request);
    List<Recording.Sample> samples = new ArrayList<>();
    List<ObjectReader> all = json.requiredObjects("samples");
    all.forEach(sample -> sample(sample).ifPresent(samples::add));
    if (all.isEmpty() && json.value("samples").isPresent()) {
      json.find(FORMAT, "A recording holds at least one sample.", json.at("samples"));
    }
    json.refuseOthers();
    return samples;
  }

  private static void request(ObjectReader json) {
    json.requiredText("provider");
    json.requiredText("model");
    json.requiredObject("sampling");
    for (ObjectReader message : json.requiredObjects("messages")) {
      message.requiredText("role");
      text(message, "content");
      message.refuseOthers();
    }
    if (!json.has("schema")) {
      json.find(FORMAT, "'schema' is missing.", json.location());
    }
    json.refuseOthers();
  }

  private Optional<Recording.Sample> sample(ObjectReader json) {
    int before = problems.size();
    String recordedAt = json.requiredText("recordedAt");
    String provenance = json.requiredText("provenance");
    String model = json.requiredText("model");
    Optional<FinishReason> reason = finishReason(json);
    Optional<Usage> usage = json.object("usage").flatMap(RecordingReader::usage);
    Optional<String> text = text(json, "text");
    if (!json.has("usage")) {
      json.find(FORMAT, "'usage' is missing; it may be null.", json.location());
    }
    json.refuseOthers();
    if (problems.size() > before) {
      return Optional.empty();
    }
    ChatResponse response =
        new ChatResponse(text.orElseThrow(), reason.orElseThrow(), model, provenance, usage);
    return Optional.of(new Recording.Sample(recordedAt, response));
  }

  private static Optional<Usage> usage(ObjectReader json) {
    long input = json.requiredWholeNumber("input", TOKENS);
    long output = json.requiredWholeNumber("output", TOKENS);
    json.refuseOthers();
    return Optional.of(new Usage(input, output));
  }

  private static Optional<FinishReason> finishReason(ObjectReader json) {
    String written = json.requiredText("finishReason");
    Optional<FinishReason> reason =
        Arrays.stream(FinishReason.values())
            .filter(known -> known.name().toLowerCase(Locale.ROOT).equals(written))
            .findFirst();
    if (reason.isEmpty() && !written.isBlank()) {
      String message = "'" + written + "' is not one of stop, length, refusal, other.";
      json.find(FORMAT, message, json.at("finishReason"));
    }
    return reason;
  }

  /** Reads a text, or its lines in an array. */
  private static Optional<String> text(ObjectReader json, String name) {
    Optional<JsonNode> value = json.value(name);
    if (value.isEmpty()) {
      json.find(FORMAT, "'" + name + "' is missing.", json.location());
    } else if (!isText(value.get())) {
      json.refuseType(name, "a string, or an array of lines without line breaks");
    }
    return value.filter(RecordingReader::isText).map(RequestJson::text);
  }

  private static boolean isText(JsonNode node) {
    if (!node.isArray()) {
      return node.isTextual();
    }
    for (JsonNode line : node) {
      if (!line.isTextual() || line.asText().contains("\n")) {
        return false;
      }
    }
    return !node.isEmpty();
  }

  private void stopOnProblems() {
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
  }
}
