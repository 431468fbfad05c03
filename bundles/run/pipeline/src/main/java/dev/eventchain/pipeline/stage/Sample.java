package dev.eventchain.pipeline.stage;

import dev.eventchain.agents.Exchange;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.ModelAccess;
import dev.eventchain.llm.Spending;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * One of several runs by which a language model is evaluated: provides its answers and stores them.
 * Thread-safe.
 */
public final class Sample {

  /** The task that finds out what is wrong after a failed verdict. */
  public static final String DIAGNOSE = "diagnose";

  private final String model;
  private final int number;
  private final Path common;
  private final Path own;
  private final Spending spending;
  private final List<Call> calls = new ArrayList<>();
  private final List<Answer> answers = new ArrayList<>();

  /**
   * An answer of a language model.
   *
   * @param task the task as in configurations; {@code verdict} for a correction after a failed
   *     verdict
   * @param repair true if it corrects an answer that was sent back
   */
  public record Call(String task, boolean repair, ChatResponse response) {}

  /**
   * An answer of a language model, as it was judged.
   *
   * @param task as in a call; {@code diagnose} for a diagnosis after a failed verdict
   * @param file the name of the file that it becomes
   * @param attempt its number among the answers to one question, from 1
   * @param accepted false if it was refused
   * @param errors the ids of its errors
   * @param bytes its length in UTF-8
   * @param usage the tokens, if they are known
   */
  public record Answer(
      String task,
      String file,
      int attempt,
      boolean accepted,
      List<String> errors,
      int bytes,
      Optional<ChatResponse.Usage> usage) {

    /** Returns whether another answer becomes the same file for the same task. */
    public boolean isAbout(Answer other) {
      return task.equals(other.task) && file.equals(other.file);
    }
  }

  /**
   * Creates a run without calls.
   *
   * @param number of the run, from 0
   * @param common the recordings of the project
   * @param own the recordings of this run
   * @param spending the spending of the whole evaluation
   */
  public Sample(String model, int number, Path common, Path own, Spending spending) {
    this.model = model;
    this.number = number;
    this.common = common;
    this.own = own;
    this.spending = spending;
  }

  /** Returns the same run without calls. */
  public Sample again() {
    return new Sample(model, number, common, own, spending);
  }

  public String model() {
    return model;
  }

  Spending spending() {
    return spending;
  }

  /** Returns the answers so far, in their order. */
  public synchronized List<Call> calls() {
    return List.copyOf(calls);
  }

  /** Returns the model for a task. */
  ChatModel open(ModelAccess usual, String task) {
    ModelAccess access =
        new ModelAccess(
            usual.source(),
            own,
            true,
            usual.services(),
            usual.spending(),
            usual.environment(),
            usual.progress(),
            usual.findings());
    ChatModel asked = ChatModels.openRun(access, model, common, number);
    return request -> {
      ChatResponse response = asked.chat(request);
      add(new Call(task, request.messages().size() > 1, response));
      return response;
    };
  }

  private synchronized void add(Call call) {
    calls.add(call);
  }

  /** Adds an answer as it was judged. */
  synchronized void add(String purpose, Exchange exchange) {
    answers.add(
        new Answer(
            exchange.task().equals(DIAGNOSE) ? DIAGNOSE : purpose,
            exchange.file(),
            exchange.attempt(),
            exchange.accepted(),
            exchange.findings().stream()
                .filter(it -> it.severity() == Severity.ERROR)
                .map(Diagnostic::id)
                .distinct()
                .toList(),
            exchange.answer().text().getBytes(StandardCharsets.UTF_8).length,
            exchange.answer().usage()));
  }

  /** Returns the answers so far as they were judged, in the order of their judgement. */
  public synchronized List<Answer> answers() {
    return List.copyOf(answers);
  }
}
