package dev.eventchain.architecture;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.IndentedCodeBlock;
import org.commonmark.node.Node;

/** Calls of {@code eventchain} in a text: in code blocks and within sentences. */
final class WrittenCommands {

  private static final Pattern CALL =
      Pattern.compile("(?m)(?:^|[\\s(;&\"'])(?:[\\w.*-]*/)*eventchain[ \\t]+(?=[a-z-])");

  /** A word of a shell: quotes preserve blanks, and {@code #} begins a comment. */
  private static final Pattern WORD =
      Pattern.compile("\\G[ \\t]*((?:'[^'\\n]*'|\"[^\"\\n]*\"|[^\\s;|&<>()'\"#]|(?<=\\S)#)+)");

  private static final Pattern CONTINUED = Pattern.compile("\\\\\\n(?:> )?\\s*");

  private final List<Call> calls = new ArrayList<>();
  private final List<String> spans = new ArrayList<>();

  /**
   * A call of the program.
   *
   * @param words its arguments
   * @param isComplete true if it can be executed as it is: sentences may omit parts
   */
  record Call(List<String> words, boolean isComplete) {}

  WrittenCommands(Node document) {
    document.accept(
        new AbstractVisitor() {
          @Override
          public void visit(FencedCodeBlock block) {
            addCalls(block.getLiteral(), true);
          }

          @Override
          public void visit(IndentedCodeBlock block) {
            addCalls(block.getLiteral(), true);
          }

          @Override
          public void visit(Code code) {
            addCalls(code.getLiteral(), false);
            spans.add(code.getLiteral());
          }
        });
  }

  List<Call> calls() {
    return calls;
  }

  /** Returns the code spans within sentences. */
  List<String> spans() {
    return spans;
  }

  private void addCalls(String code, boolean isBlock) {
    String text = CONTINUED.matcher(code).replaceAll(" ");
    Matcher call = CALL.matcher(text);
    while (call.find()) {
      calls.add(new Call(words(text.substring(call.end())), isBlock));
    }
  }

  /** Returns the words up to the end of a command. */
  static List<String> words(String text) {
    List<String> words = new ArrayList<>();
    Matcher word = WORD.matcher(text);
    while (word.find()) {
      words.add(word.group(1).replaceAll("['\"]", ""));
    }
    return words;
  }
}
