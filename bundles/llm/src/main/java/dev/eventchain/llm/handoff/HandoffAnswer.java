package dev.eventchain.llm.handoff;

import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ModelName;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The answer file of the hand-off: the plain answer, optionally after lines such as {@code <!--
 * model: gpt-4o-2024-08-06 -->} and {@code <!-- provenance: authored -->} that identify its origin.
 */
final class HandoffAnswer {
  private static final Pattern STATEMENT =
      Pattern.compile("\\A<!-- (model|provenance): (\\S[^\\n]*?) -->\\n+");

  private HandoffAnswer() {}

  static ChatResponse parse(String text, String defaultModel) {
    String rest = text.replace("\r\n", "\n");
    String model = defaultModel;
    String provenance = ModelName.PERSON;
    for (Matcher next = STATEMENT.matcher(rest); next.find(); next = STATEMENT.matcher(rest)) {
      if (next.group(1).equals("model")) {
        model = next.group(2);
      } else {
        provenance = next.group(2);
      }
      rest = rest.substring(next.end());
    }
    return new ChatResponse(
        rest.stripTrailing(), FinishReason.STOP, model, provenance, Optional.empty());
  }
}
