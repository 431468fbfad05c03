package dev.eventchain.llm.service;

import dev.eventchain.llm.chat.AnswerSchema.Shape;
import dev.langchain4j.model.anthropic.AnthropicStreamingChatModel;
import dev.langchain4j.model.chat.StreamingChatModel;
import dev.langchain4j.model.googleai.GoogleAiGeminiStreamingChatModel;
import dev.langchain4j.model.ollama.OllamaStreamingChatModel;
import dev.langchain4j.model.openai.OpenAiStreamingChatModel;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** How a service is spoken to. */
public enum Wire {
  /** OpenAI itself, which limits the hidden reasoning together with the answer. */
  OPENAI("openai", Shape.NESTED) {
    @Override
    StreamingChatModel model(Call call) {
      return openAi(call).maxCompletionTokens(call.maximumTokens()).build();
    }
  },
  /** Whoever speaks as OpenAI once did: Groq, vLLM, llama.cpp and many more. */
  OPENAI_COMPATIBLE("openai-compatible", Shape.NESTED) {
    @Override
    StreamingChatModel model(Call call) {
      return openAi(call).maxTokens(call.maximumTokens()).build();
    }
  },
  /** Google's Gemini. */
  GEMINI("gemini", Shape.FLAT) {
    @Override
    StreamingChatModel model(Call call) {
      return GoogleAiGeminiStreamingChatModel.builder()
          .httpClientBuilder(call.transport().builder())
          .baseUrl(call.url())
          .apiKey(call.keyOrNone())
          .modelName(call.model())
          .temperature(call.temperature())
          .seed(call.seed())
          .maxOutputTokens(call.maximumTokens())
          .build();
    }
  },
  /** Anthropic, whose client cuts answers at 1,024 tokens unless it is told otherwise. */
  ANTHROPIC("anthropic", Shape.FLAT) {
    @Override
    StreamingChatModel model(Call call) {
      return AnthropicStreamingChatModel.builder()
          .httpClientBuilder(call.transport().builder())
          .baseUrl(call.url())
          .apiKey(call.keyOrNone())
          .modelName(call.model())
          .temperature(call.temperature())
          .maxTokens(call.maximumTokens())
          .build();
    }
  },
  /** Ollama, by its own protocol. */
  OLLAMA("ollama", Shape.NESTED) {
    @Override
    StreamingChatModel model(Call call) {
      return OllamaStreamingChatModel.builder()
          .httpClientBuilder(call.transport().builder())
          .baseUrl(call.url())
          .customHeaders(
              call.key().isEmpty() ? Map.of() : Map.of("Authorization", "Bearer " + call.key()))
          .modelName(call.model())
          .temperature(call.temperature())
          .seed(call.seed())
          .numPredict(call.maximumTokens())
          .build();
    }
  };

  /**
   * What a client needs.
   *
   * @param key empty where the service wants none
   * @param temperature null: left to the service
   * @param seed null: left to the service
   */
  record Call(
      Transport transport,
      String url,
      String key,
      String model,
      Double temperature,
      Integer seed,
      int maximumTokens) {
    /** The client libraries refuse to send nothing. */
    String keyOrNone() {
      return key.isEmpty() ? "none" : key;
    }
  }

  private final String id;
  private final Shape shape;

  Wire(String id, Shape shape) {
    this.id = id;
    this.shape = shape;
  }

  /**
   * The shape of the schema that a service takes. Anthropic's knows no recursion, and takes 16
   * properties with alternatives and 24 that are not required; Gemini's follows a recursion only in
   * properties that are not required. The others want every property to be required, or turn the
   * schema into a grammar.
   */
  public Shape shape() {
    return shape;
  }

  /** What is in configurations. */
  String id() {
    return id;
  }

  static List<String> ids() {
    return Arrays.stream(values()).map(Wire::id).toList();
  }

  static Optional<Wire> of(String id) {
    return Arrays.stream(values()).filter(wire -> wire.id.equals(id)).findFirst();
  }

  /** A client for one attempt. */
  abstract StreamingChatModel model(Call call);

  private static OpenAiStreamingChatModel.OpenAiStreamingChatModelBuilder openAi(Call call) {
    return OpenAiStreamingChatModel.builder()
        .httpClientBuilder(call.transport().builder())
        .baseUrl(call.url())
        .apiKey(call.keyOrNone())
        .modelName(call.model())
        .temperature(call.temperature())
        .seed(call.seed())
        .strictJsonSchema(true);
  }
}
