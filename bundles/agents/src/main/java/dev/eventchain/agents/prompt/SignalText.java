package dev.eventchain.agents.prompt;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.description.SoftwareBaseNames;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.JsonDocument;
import java.util.ArrayList;
import java.util.List;

/** Existing signals in prompts, a line for each signal and for each field. */
public final class SignalText {
  private SignalText() {}

  /**
   * Returns the text of signals.
   *
   * @param json the content of {@code signals.json}, without errors
   */
  public static String of(String json) {
    List<String> lines = new ArrayList<>();
    for (JsonNode signal :
        JsonDocument.parse(SourceText.of(SoftwareBaseNames.SIGNALS, json)).root()) {
      lines.add(
          "- %s (%s, %s, %s)"
              .formatted(
                  signal.path("Topic Name").asText(),
                  signal.path("Message Type").asText(),
                  quality(signal.path("qos_profile")),
                  signal.path("direction").asText("internal")));
      signal.path("Message Definition").forEach(field -> lines.add(field(field)));
    }
    return lines.isEmpty() ? "None." : String.join("\n", lines);
  }

  private static String quality(JsonNode profile) {
    return profile.isTextual()
        ? profile.asText()
        : profile.isMissingNode() ? "default" : profile.toString();
  }

  private static String field(JsonNode field) {
    String unit = field.path("Unit").asText("");
    String meaning = field.path("Description").asText("");
    return "  %s: %s%s%s"
        .formatted(
            field.path("Field").asText(),
            field.path("Type").asText(),
            unit.isEmpty() ? "" : ", " + unit,
            meaning.isEmpty() ? "" : " -- " + meaning);
  }
}
