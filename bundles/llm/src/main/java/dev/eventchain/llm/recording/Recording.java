package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.RequestJson;
import dev.eventchain.llm.chat.RequestKey;
import java.util.ArrayList;
import java.util.List;

/**
 * A recorded request with its answers.
 *
 * @param key identifies the request
 * @param request the request as {@link RequestJson#of} gives it
 * @param samples the answers: the n-th identical request of a run gets sample n
 */
record Recording(RequestKey key, ObjectNode request, List<Sample> samples) {
  /**
   * One recorded answer.
   *
   * @param recordedAt ISO 8601 instant
   * @param response the answer
   */
  record Sample(String recordedAt, ChatResponse response) {}

  Recording {
    samples = List.copyOf(samples);
  }

  static Recording of(ObjectNode request) {
    return new Recording(RequestKey.of(request), request, List.of());
  }

  /**
   * Returns this recording with {@code sample} as answer number {@code index}. An equal answer
   * changes nothing, so that a repeated run writes nothing.
   */
  Recording with(int index, Sample sample) {
    List<Sample> changed = new ArrayList<>(samples);
    if (index >= changed.size()) {
      changed.add(sample);
    } else if (!changed.get(index).response().equals(sample.response())) {
      changed.set(index, sample);
    }
    return new Recording(key, request, changed);
  }
}
