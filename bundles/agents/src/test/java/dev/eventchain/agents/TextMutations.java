package dev.eventchain.agents;

import static dev.eventchain.agents.Mutation.equal;
import static dev.eventchain.agents.Mutation.rejected;

import dev.eventchain.agents.Mutation.Change;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.UnaryOperator;

/** Mutations of any answer: surrounding text, and truncation. */
final class TextMutations {
  private TextMutations() {}

  /** Returns mutations of the text around an artefact that are tolerated. */
  static List<Mutation> around() {
    return List.of(
        equal("prose around", always(text -> "Here [it] is:\n\n" + text + "\n\nAsk {me} more.\n")),
        equal("thinking before", always(text -> "<think>\nFirst ```[1]```.\n</think>\n" + text)),
        equal("the end of thinking before", always(text -> "Well.\n</think>\n\n" + text)),
        equal("line ends of Windows", always(text -> text.replace("\n", "\r\n"))),
        equal("a byte order mark", always(text -> "\uFEFF" + text)),
        equal("a longer fence", always(text -> "``" + text + "``")),
        equal("waves for a fence", always(text -> text.replace("```", "~~~"))),
        equal("a fence without a tag", always(text -> text.replaceFirst("```\\w+", "```"))),
        equal("the block twice", always(text -> text + "\nOnce more:\n" + text)),
        equal("a block of the shell before", always(text -> "```bash\nls\n```\n" + text)));
  }

  /** Returns mutations that leave no artefact. */
  static List<Mutation> broken() {
    return List.of(
        rejected("cut", TextMutations::cut),
        rejected("another block of the same kind", TextMutations::twoBlocks),
        rejected("another tag", always(text -> text.replaceFirst("```\\w+", "```yaml"))),
        rejected("only prose", always(text -> "I am sorry, I cannot do this.")),
        rejected("thinking without an end", always(text -> "<think>\n" + text)));
  }

  static Change always(UnaryOperator<String> change) {
    return (answer, random) -> Optional.of(change.apply(answer.text()));
  }

  /** Truncates the answer anywhere before the last character of the block. */
  private static Optional<String> cut(GoodAnswer answer, Random random) {
    String text = answer.text();
    int first = text.indexOf('\n') + 1;
    int last = text.substring(0, text.lastIndexOf("```")).stripTrailing().length() - 1;
    return Optional.of(text.substring(0, first + random.nextInt(last - first)));
  }

  private static Optional<String> twoBlocks(GoodAnswer answer, Random random) {
    String other = answer.text().replaceFirst("(?s)[0-9](?!.*[0-9])", "");
    return other.equals(answer.text())
        ? Optional.empty()
        : Optional.of(answer.text() + "\nor\n" + other);
  }
}
