package dev.eventchain.llm;

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
enum Wire {
  /** OpenAI itself, which limits the hidden reasoning together with the answer. */
  OPENAI("openai") {
    @Override
    StreamingChatModel model(Call call) {
      return openAi(call).maxCompletionTokens(call.maximumTokens()).build();
    }
  },
  /** Whoever speaks as OpenAI once did: Groq, vLLM, llama.cpp and many more. */
  OPENAI_COMPATIBLE("openai-compatible") {
    @Override
    StreamingChatModel model(Call call) {
      return openAi(call).maxTokens(call.maximumTokens()).build();
    }
  },
  /** Google's Gemini. */
  GEMINI("gemini") {
    @Override
    StreamingChatModel model(Call call) {
      return GoogleAiGeminiStreamingChatModel.builder()
          .httpClientBuilder(call.transport().builder())
          .baseUrl(call.url())
          .apiKey(call.key())
          .modelName(call.model())
          .temperature(call.temperature())
          .seed(call.seed())
          .maxOutputTokens(call.maximumTokens())
          .build();
    }
  },
  /** Anthropic, whose client cuts answers at 1,024 tokens unless it is told otherwise. */
  ANTHROPIC("anthropic") {
    @Override
    StreamingChatModel model(Call call) {
      return AnthropicStreamingChatModel.builder()
          .httpClientBuilder(call.transport().builder())
          .baseUrl(call.url())
          .apiKey(call.key())
          .modelName(call.model())
          .temperature(call.temperature())
          .maxTokens(call.maximumTokens())
          .build();
    }
  },
  /** Ollama, by its own protocol. */
  OLLAMA("ollama") {
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
      int maximumTokens) {}

  private final String id;

  Wire(String id) {
    this.id = id;
  }

  /** What stands in configurations. */
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
        .apiKey(call.key().isEmpty() ? "none" : call.key())
        .modelName(call.model())
        .temperature(call.temperature())
        .seed(call.seed())
        .strictJsonSchema(true);
  }
}
