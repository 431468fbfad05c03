package dev.eventchain.ocl.metamodel;

import dev.eventchain.ocl.evaluation.Invalid;
import java.util.Collection;
import java.util.Iterator;
import org.eclipse.emf.common.util.Enumerator;
import org.eclipse.emf.ecore.EObject;

/** Texts of values in messages: short, on one line, with quotes around texts. */
public final class ValueTexts {

  private static final int LONGEST = 80;

  private ValueTexts() {}

  /** Returns the value with the verb: {@code is 5.0}, {@code is empty}, {@code is {'a', 'b'}}. */
  public static String predicate(Object value) {
    return value instanceof Collection<?> elements && elements.isEmpty()
        ? "is empty"
        : "is " + of(value);
  }

  /** Returns a value, shortened if it is long. */
  public static String of(Object value) {
    if (value instanceof Invalid) {
      return "undefined";
    } else if (value instanceof String text) {
      return "'" + shortened(text) + "'";
    } else if (value instanceof Enumerator literal) {
      return literal.getName();
    } else if (value instanceof EObject object) {
      return Names.label(object);
    } else if (value instanceof Collection<?> elements) {
      return list(elements);
    }
    return shortened(String.valueOf(value));
  }

  private static String list(Collection<?> elements) {
    StringBuilder text = new StringBuilder("{");
    int shown = 0;
    for (Iterator<?> each = elements.iterator(); each.hasNext(); shown++) {
      String next = of(each.next());
      if (shown > 0 && text.length() + next.length() > LONGEST) {
        return text.append(", ").append(elements.size() - shown).append(" more}").toString();
      }
      text.append(shown == 0 ? "" : ", ").append(next);
    }
    return text.append('}').toString();
  }

  /** Returns a text on one line, cut after eighty characters. */
  public static String shortened(String text) {
    int end = text.length();
    if (end > LONGEST) {
      end = LONGEST - 3;
      end -= Character.isHighSurrogate(text.charAt(end - 1)) ? 1 : 0;
    }
    String start = text.substring(0, end).replace("\r", "").replace("\n", "\\n");
    return end < text.length() ? start + "..." : start;
  }
}
