package dev.eventchain.llm.service;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.langchain4j.http.client.sse.ServerSentEvent;
import dev.langchain4j.http.client.sse.ServerSentEventContext;
import dev.langchain4j.http.client.sse.ServerSentEventListener;
import java.io.IOException;

/**
 * Forwards events, but retains those that the client library would mistake for an answer: error
 * events and unreadable ones.
 */
final class ErrorEvents implements ServerSentEventListener {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final ServerSentEventListener listener;
  private CallFailure failure;
  private IOException broken;

  ErrorEvents(ServerSentEventListener listener) {
    this.listener = listener;
  }

  /** Throws the failure of an exchange that failed while it was read. */
  void throwFailure() throws IOException {
    if (failure != null) {
      throw failure;
    }
    if (broken != null) {
      throw broken;
    }
  }

  @Override
  public void onEvent(ServerSentEvent event, ServerSentEventContext context) {
    if (isPassedOn(event)) {
      listener.onEvent(event, context);
    }
  }

  @Override
  public void onEvent(ServerSentEvent event) {
    if (isPassedOn(event)) {
      listener.onEvent(event);
    }
  }

  /** Returns whether an event is forwarded: none is after the first failure. */
  private boolean isPassedOn(ServerSentEvent event) {
    if (failure == null && broken == null && !isEnd(event)) {
      look(event);
    }
    return failure == null && broken == null;
  }

  private static boolean isEnd(ServerSentEvent event) {
    return event.data() == null || event.data().isBlank() || event.data().equals("[DONE]");
  }

  private void look(ServerSentEvent event) {
    try {
      JsonNode data = MAPPER.readTree(event.data());
      JsonNode error = data.path("error");
      if ("error".equals(event.event()) || (!error.isMissingNode() && !error.isNull())) {
        failure = ErrorBody.ofEvent(data);
      }
    } catch (JsonProcessingException e) {
      failure =
          new CallFailure(
              CallFailure.Kind.UNREADABLE,
              "a part of the answer is not valid JSON: " + ErrorBody.shown(event.data()),
              "Check the service's 'url' and 'wire' in eventchain.yaml.");
    }
  }

  @Override
  public void onError(Throwable throwable) {
    if (throwable instanceof CallFailure known) {
      failure = failure == null ? known : failure;
    } else if (throwable instanceof IOException io) {
      broken = broken == null ? io : broken;
    } else {
      broken = broken == null ? new IOException(throwable) : broken;
    }
  }
}
