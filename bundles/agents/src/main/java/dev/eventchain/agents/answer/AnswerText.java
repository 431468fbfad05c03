package dev.eventchain.agents.answer;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;

/**
 * The artefact in an answer. Fences, a preamble, trailing prose and the model's reasoning are
 * dropped; a truncated, unusable or ambiguous answer is refused.
 *
 * @param artefact the artefact, if it could be extracted
 * @param problems the reasons why there is none
 */
public record AnswerText(Optional<SourceText> artefact, List<Diagnostic> problems) {
  private static final int FLAGS = Pattern.DOTALL | Pattern.MULTILINE;

  /** Reasoning of the model; its opening tag is often part of the server's prefix of the answer. */
  private static final Pattern THINKING =
      Pattern.compile("\\A(\\s*<(think|thinking)>.*?</\\2>|.*?^</(think|thinking)>)\\s*", FLAGS);

  private static final Pattern THINKING_WITHOUT_END = Pattern.compile("\\A\\s*<(think|thinking)>");
  private static final Pattern PROSE = Pattern.compile("^[A-Z][A-Za-z']*,? [a-z].*");

  public static AnswerText extract(AnswerKind kind, String file, ChatResponse response) {
    if (response.finishReason() == FinishReason.LENGTH) {
      return truncated(file, "The answer was cut at the limit of its length.");
    }
    if (response.finishReason() != FinishReason.STOP) {
      return problem(AnswerFormRules.ANSWER_REFUSED, "The model did not finish its answer.", file);
    }
    String text = response.text().replace("\r\n", "\n").replace("\uFEFF", "");
    text = THINKING.matcher(text).replaceFirst("");
    if (THINKING_WITHOUT_END.matcher(text).find()) {
      return truncated(file, "The answer ends inside the thinking that comes before it.");
    }
    FencedBlocks blocks = FencedBlocks.in(text);
    if (!blocks.all().isEmpty()) {
      return fenced(kind, file, blocks);
    }
    if (kind == AnswerKind.JSON) {
      return JsonAnswer.search(file, text);
    }
    return bare(kind, file, text.lines().toList());
  }

  /** Returns a copy with the artefact converted. */
  public AnswerText map(UnaryOperator<SourceText> form) {
    return new AnswerText(artefact.map(form), problems);
  }

  private static AnswerText fenced(AnswerKind kind, String file, FencedBlocks blocks) {
    List<FencedBlocks.Block> candidates = blocks.candidates(kind);
    if (candidates.isEmpty()) {
      return nothing(kind, file);
    }
    if (candidates.size() > 1) {
      return several(kind, file, candidates.size());
    }
    FencedBlocks.Block block = candidates.get(0);
    if (kind == AnswerKind.JSON) {
      return JsonAnswer.parse(file, block.text());
    }
    return block.closed()
        ? found(file, block.text())
        : truncated(file, "The answer ends inside its code block.");
  }

  private static AnswerText bare(AnswerKind kind, String file, List<String> lines) {
    int start = 0;
    while (start < lines.size() && !kind.startsWith(lines.get(start))) {
      start++;
    }
    if (start == lines.size()) {
      return nothing(kind, file);
    }
    List<String> kept = new ArrayList<>(lines.subList(start, lines.size()));
    while (endsWithProse(kept)) {
      kept.remove(kept.size() - 1);
    }
    return found(file, String.join("\n", kept));
  }

  private static boolean endsWithProse(List<String> lines) {
    String last = lines.get(lines.size() - 1);
    return last.isBlank() || PROSE.matcher(last).matches();
  }

  static AnswerText found(String file, String text) {
    return new AnswerText(Optional.of(SourceText.of(file, text.stripTrailing() + "\n")), List.of());
  }

  static AnswerText truncated(String file, String message) {
    return problem(AnswerFormRules.ANSWER_TRUNCATED, message, file);
  }

  static AnswerText several(AnswerKind kind, String file, int count) {
    return problem(
        AnswerFormRules.ANSWER_SEVERAL,
        String.format(
            Locale.ROOT,
            "The answer contains %d different blocks that may be the %s.",
            count,
            kind.description()),
        file);
  }

  static AnswerText nothing(AnswerKind kind, String file) {
    return problem(
        AnswerFormRules.ANSWER_NONE,
        "The answer contains no %s.".formatted(kind.description()),
        file);
  }

  static AnswerText problem(Rule rule, String message, String file) {
    return problem(Diagnostic.of(rule, message, SourceLocation.of(file)));
  }

  static AnswerText problem(Diagnostic diagnostic) {
    return new AnswerText(Optional.empty(), List.of(diagnostic));
  }
}
