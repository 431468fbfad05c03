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

/** Protocols of services. */
public enum Wire {
  /** OpenAI itself, which limits hidden reasoning and answer together. */
  OPENAI("openai", Shape.NESTED) {
    @Override
    StreamingChatModel model(Call call) {
      return openAi(call).maxCompletionTokens(call.maximumTokens()).build();
    }
  },
  /** Services with OpenAI's earlier protocol: Groq, vLLM, llama.cpp and many more. */
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
  /** Anthropic, whose client truncates answers at 1,024 tokens by default. */
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
  /** Ollama, by its native protocol. */
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
   * Parameters of a client.
   *
   * @param key empty if the service needs none
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
    /** Returns the key or a placeholder: the client libraries reject an empty one. */
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
   * Returns the shape of the service's schemas. Anthropic allows no recursion, and at most 16
   * properties with alternatives and 24 optional ones; Gemini follows recursion only in optional
   * properties. The others require every property, or turn the schema into a grammar.
   */
  public Shape shape() {
    return shape;
  }

  /** Returns the id in configurations. */
  String id() {
    return id;
  }

  static List<String> ids() {
    return Arrays.stream(values()).map(Wire::id).toList();
  }

  static Optional<Wire> of(String id) {
    return Arrays.stream(values()).filter(wire -> wire.id.equals(id)).findFirst();
  }

  /** Returns a client for one attempt. */
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
