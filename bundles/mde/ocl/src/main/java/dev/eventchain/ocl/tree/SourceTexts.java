package dev.eventchain.ocl.tree;

import dev.eventchain.ocl.metamodel.ValueTexts;
import dev.eventchain.ocl.text.Lexer;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.expressions.OCLExpression;

/** The texts of expressions as in the source. */
public final class SourceTexts {

  /** Tokens around which white space is only that of line breaks. */
  private static final Set<String> JOINING = Set.of(".", "->", "::");

  private SourceTexts() {}

  /** Returns the text of an expression, with single spaces, and shortened. */
  public static String of(OCLExpression<EClassifier> part) {
    return InvalidOrigin.source(part).map(each -> textIn(each.text().text(), part)).orElse("");
  }

  private static String textIn(String source, OCLExpression<EClassifier> part) {
    int start = Math.max(0, part.getStartPosition());
    int end = Math.min(source.length(), part.getEndPosition());
    if (start >= end) {
      return "";
    }
    StringBuilder words = new StringBuilder();
    String last = "";
    boolean blank = false;
    for (int i = start; i < end; ) {
      int next = Lexer.end(source, i, end);
      if (Lexer.isBlank(source, i)) {
        blank = !last.isEmpty();
      } else {
        String word = source.substring(i, next);
        boolean joined = JOINING.contains(last) || JOINING.contains(word);
        words.append(blank && !joined ? " " : "").append(word);
        last = word;
        blank = false;
      }
      i = next;
    }
    return ValueTexts.shortened(withoutParentheses(words.toString()));
  }

  /** Removes parentheses around the whole text. */
  private static String withoutParentheses(String text) {
    int depth = 0;
    for (int i = 0; i < text.length(); i = Lexer.end(text, i, text.length())) {
      char c = text.charAt(i);
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (depth == 0 && i < text.length() - 1) {
        return text;
      }
    }
    return text.startsWith("(")
        ? withoutParentheses(text.substring(1, text.length() - 1).strip())
        : text;
  }
}
