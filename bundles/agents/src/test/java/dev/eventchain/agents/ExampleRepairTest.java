package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.Sampling;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each task of each example with a fault in its first answer that the task's checks must detect.
 * The answer goes back with the findings, and the recorded answer repairs it.
 */
class ExampleRepairTest {
  /** Correct text in a task's answer, and its faulty replacement. */
  private static final Map<String, Slip> SLIPS =
      Map.of(
          "design", new Slip("\"frequency\":", "\"freqency\":"),
          "test", new Slip("\"requirement\":", "\"requirment\":"),
          "implement", new Slip("def execute(", "def run("),
          "model", new Slip("\"eClass\": \"SoftwareNode\"", "\"eClass\": \"SoftwareNod\""),
          "constrain", new Slip("self.", "self.unheardOf."));

  private record Slip(String right, String wrong) {}

  /** The recorded answers, with a fault in the first answer of each conversation. */
  private record Slipping(ChatModel recorded) implements ChatModel {
    @Override
    public ChatResponse chat(ChatRequest request) {
      ChatRequest first =
          new ChatRequest(
              request.task(), request.messages().subList(0, 1), request.schema(), Sampling.DEFAULT);
      ChatResponse answer = recorded.chat(first);
      if (request.messages().size() > 1) {
        return answer;
      }
      Slip slip = SLIPS.get(request.task());
      String wrong = answer.text().replaceFirst(Pattern.quote(slip.right()), slip.wrong());
      assertNotEquals(answer.text(), wrong, request.task());
      return new ChatResponse(
          wrong, answer.finishReason(), answer.model(), answer.provenance(), answer.usage());
    }
  }

  static List<ExampleWorkflow> examples() {
    return ExampleRecordingsTest.examples();
  }

  @InTurn
  @ParameterizedTest
  @MethodSource("examples")
  void everyTaskRepairsASlip(ExampleWorkflow example) {
    // Each prompt is sent twice, and recorded once.
    ChatModel recorded =
        request ->
            ChatModels.open("replay", ExampleWorkflow.MODEL, example.recordings(), false)
                .chat(request);
    Map<String, AgentResult> right = example.run(recorded);
    Map<String, AgentResult> repaired = example.run(new Slipping(recorded));
    assertEquals(right.keySet(), repaired.keySet());
    repaired.forEach(
        (file, result) -> {
          assertEquals(2, result.attempts().size(), file);
          assertFalse(result.attempts().get(0).findings().isEmpty(), file);
          assertEquals(right.get(file).text(), result.text(), file);
        });
  }
}
