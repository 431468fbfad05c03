package dev.eventchain.llm.service;

import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatMessage.Role;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ChatResponse.Usage;
import dev.eventchain.llm.chat.ModelName;
import dev.langchain4j.data.message.AiMessage;
import dev.langchain4j.data.message.UserMessage;
import dev.langchain4j.exception.HttpException;
import dev.langchain4j.model.chat.request.ResponseFormat;
import dev.langchain4j.model.chat.request.ResponseFormatType;
import dev.langchain4j.model.chat.request.json.JsonRawSchema;
import dev.langchain4j.model.chat.request.json.JsonSchema;
import dev.langchain4j.model.chat.response.PartialThinking;
import dev.langchain4j.model.chat.response.StreamingChatResponseHandler;
import dev.langchain4j.model.output.TokenUsage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;

/** One attempt at a call. */
final class ServiceCall implements StreamingChatResponseHandler {
  private static final long TELL_EVERY = 250_000_000L; // ns

  private final ModelService service;
  private final ModelName name;
  private final String key;
  private final Transport transport;
  private final Consumer<String> progress;
  private int characters;
  private boolean begun;
  private long toldAt;
  private dev.langchain4j.model.chat.response.ChatResponse complete;
  private Throwable problem;

  ServiceCall(
      ModelService service,
      ModelName name,
      String key,
      Deadline deadline,
      Consumer<String> progress) {
    this.service = service;
    this.name = name;
    this.key = key;
    this.progress = progress;
    this.transport = new Transport(deadline, service.silence());
  }

  /** Returns whether a part of an answer has arrived, which may have been charged. */
  boolean hasBegun() {
    return begun;
  }

  /**
   * Sends the request, and waits for the complete answer.
   *
   * @throws CallFailure if there is none
   */
  ChatResponse ask(ChatRequest request) {
    Wire.Call call =
        new Wire.Call(
            transport,
            service.url().toString(),
            key,
            name.name(),
            boxed(request.sampling().temperature()),
            request.sampling().seed().isPresent()
                ? Math.toIntExact(request.sampling().seed().getAsLong())
                : null,
            request.sampling().maximumTokens().orElse(service.maximumTokens()));
    try {
      service.wire().model(call).chat(toLibrary(request), this);
    } catch (RuntimeException e) {
      problem = problem == null ? e : problem;
    }
    try {
      transport.throwFailure();
    } catch (CallFailure failure) {
      throw request.schema().isPresent() ? failure.ofSchema() : failure;
    }
    if (problem != null) {
      throw unreadable(problem);
    }
    return toOurs();
  }

  private static Double boxed(java.util.OptionalDouble value) {
    return value.isPresent() ? value.getAsDouble() : null;
  }

  private static dev.langchain4j.model.chat.request.ChatRequest toLibrary(ChatRequest request) {
    List<dev.langchain4j.data.message.ChatMessage> messages =
        request.messages().stream().map(ServiceCall::toLibrary).toList();
    dev.langchain4j.model.chat.request.ChatRequest.Builder builder =
        dev.langchain4j.model.chat.request.ChatRequest.builder().messages(messages);
    request
        .schema()
        .ifPresent(
            schema ->
                builder.responseFormat(
                    ResponseFormat.builder()
                        .type(ResponseFormatType.JSON)
                        .jsonSchema(
                            JsonSchema.builder()
                                .name(request.task())
                                .rootElement(JsonRawSchema.from(schema.chosen().toString()))
                                .build())
                        .build()));
    return builder.build();
  }

  private static dev.langchain4j.data.message.ChatMessage toLibrary(ChatMessage message) {
    return message.role() == Role.USER
        ? UserMessage.from(message.content())
        : AiMessage.from(message.content());
  }

  @Override
  public void onPartialResponse(String part) {
    begun = true;
    characters += part.length();
    long now = System.nanoTime();
    if (now - toldAt > TELL_EVERY) {
      toldAt = now;
      progress.accept(String.format(Locale.ROOT, "%s answers: %,d characters", name, characters));
    }
  }

  @Override
  public void onPartialThinking(PartialThinking part) {
    begun = true;
    long now = System.nanoTime();
    if (now - toldAt > TELL_EVERY) {
      toldAt = now;
      progress.accept(name + " thinks");
    }
  }

  @Override
  public void onCompleteResponse(dev.langchain4j.model.chat.response.ChatResponse response) {
    complete = response;
  }

  @Override
  public void onError(Throwable error) {
    problem = problem == null ? error : problem;
  }

  private static CallFailure unreadable(Throwable problem) {
    String detail =
        problem instanceof HttpException || problem.getMessage() == null
            ? problem.getClass().getSimpleName()
            : ErrorBody.shown(problem.getMessage());
    return new CallFailure(
        CallFailure.Kind.UNREADABLE,
        "the answer cannot be understood: " + detail,
        "Check the service's 'url' and 'wire' in eventchain.yaml.");
  }

  /**
   * Converts the answer. The client library takes a stream without an end marker for a complete
   * answer.
   */
  private ChatResponse toOurs() {
    if (complete == null || complete.finishReason() == null) {
      throw new CallFailure(
          CallFailure.Kind.CUT,
          "the answer ended after " + characters + " characters, before its end",
          "Try again.");
    }
    String text = complete.aiMessage().text();
    String answering = complete.modelName();
    return new ChatResponse(
        text == null ? "" : text,
        reason(complete.finishReason()),
        answering == null || answering.isBlank() ? name.name() : answering,
        service.name(),
        Optional.ofNullable(complete.tokenUsage()).flatMap(ServiceCall::usage));
  }

  private static FinishReason reason(dev.langchain4j.model.output.FinishReason reason) {
    return switch (reason) {
      case STOP -> FinishReason.STOP;
      case LENGTH -> FinishReason.LENGTH;
      case CONTENT_FILTER -> FinishReason.REFUSAL;
      default -> FinishReason.OTHER;
    };
  }

  /**
   * Returns the usage. Hidden reasoning is charged as output; some services count it in the total
   * only.
   */
  private static Optional<Usage> usage(TokenUsage usage) {
    if (usage.inputTokenCount() == null || usage.outputTokenCount() == null) {
      return Optional.empty();
    }
    int input = usage.inputTokenCount();
    int total = usage.totalTokenCount() == null ? 0 : usage.totalTokenCount();
    return Optional.of(new Usage(input, Math.max(usage.outputTokenCount(), total - input)));
  }
}
