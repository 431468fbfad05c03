package dev.eventchain.agents;

import static dev.eventchain.agents.JsonMutations.replaced;
import static dev.eventchain.agents.Mutation.rejected;
import static dev.eventchain.agents.Mutation.visible;

import dev.eventchain.agents.Mutation.Change;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;

/** Mutations of OCL documents. */
final class OclMutations {
  private static final String BODY = "(?s)(inv \\w+:\\s*)(.*?)(?=\\n\\n|\\n*$)";

  private OclMutations() {}

  static List<Mutation> all() {
    return List.of(
        rejected("an unknown feature", in("(?<=self\\.)\\w+", found -> found + "X")),
        rejected("an unknown class", in("(?<=context )\\w+", found -> found + "Class")),
        rejected("an unknown operation", in("(?<=->)\\w+", found -> found + "Of")),
        rejected("a parenthesis is missing", in("[()](?!.*--)(?=[^-\\n]*\\n)", found -> "")),
        rejected("a dot for an arrow", in("->(?=notEmpty|forAll)", found -> ".")),
        rejected("double quotes", in("'[^'\\n]*'(?! )|(?<=inv )\\w+", found -> '"' + found + '"')),
        rejected(
            "a misspelt keyword",
            in("\\b(context|implies|inv)\\b(?=[^-]*$)", found -> found + "s")),
        rejected("no id of a rule", in("-- DR-\\d+: ", found -> "-- ")),
        rejected(
            "an empty line behind the id of a rule",
            in("(?<=-- DR-.{1,300})\\n(?=context)", found -> "\n\n")),
        rejected(
            "a number for a truth value",
            in(BODY, found -> found.replaceFirst("(?s)(inv \\w+:\\s*).*", "$1self.name.size()"))),
        rejected(
            "a name twice",
            whole(answer -> answer.withBlock(answer.block() + "\n" + answer.block()))),
        rejected(
            "prose in the block",
            whole(
                answer -> answer.withBlock(answer.block() + "\nThis is all that is asked for.\n"))),
        visible("another number", in("\\d+(?=\\.0)", found -> found + "1")),
        visible("another name of a constraint", in("(?<=inv )\\w+", found -> found + "2")),
        visible("another comment", in("(?<=-- DR-\\d: )\\w+", found -> found + " (so it is)")),
        visible("above for at least", in(">=|<=", found -> found.substring(0, 1))));
  }

  /** Returns slow mutations: no model is found that satisfies and violates them. */
  static List<Mutation> slow() {
    return List.of(
        rejected(
            "true in its place",
            in(BODY, found -> found.replaceFirst("(?s)(inv \\w+:\\s*).*", "$1true"))),
        rejected(
            "false in its place",
            in(BODY, found -> found.replaceFirst("(?s)(inv \\w+:\\s*).*", "$1false"))));
  }

  private static Change whole(Function<GoodAnswer, String> change) {
    return (answer, random) -> Optional.of(change.apply(answer));
  }

  private static Change in(String regex, UnaryOperator<String> by) {
    return replaced(Pattern.compile(regex), (found, random) -> by.apply(found));
  }
}
