package dev.eventchain.m2t.syntax;

import dev.eventchain.m2t.syntax.BodyTree.Body;
import dev.eventchain.m2t.syntax.BodyTree.Part;
import java.util.ArrayList;
import java.util.List;

/**
 * Normaliser of the white space around tags, run once for a template. The rules are those of
 * Acceleo 3.7.11, also where they look arbitrary. A text loses
 *
 * <ul>
 *   <li>at its start the <b>rest of a line</b> that is blank, with its break, if it is the first
 *       one in a block of several lines, follows such a block, or is on a line that does not speak;
 *   <li>at its end the <b>indentation</b> of a line, if it is the last one in a block of several
 *       lines, such a block follows, or that line does not speak;
 *   <li>the <b>last line break</b> of a template.
 * </ul>
 *
 * <p>A line speaks if an expression, a protected area or a text that is not blank is on it;
 * comments and tags of blocks do not. The first and the last part of a body are not looked at.
 */
final class WhiteSpace {
  private final BodyTree tree;

  private WhiteSpace(BodyTree tree) {
    this.tree = tree;
  }

  /**
   * Returns the output of each text token with its offset.
   *
   * @param tokens balanced tokens
   * @return the text of each token; empty for tags
   */
  static List<Syntax.Text> normalise(String source, List<Token> tokens) {
    List<Syntax.Text> texts = new ArrayList<>(tokens.size());
    tokens.forEach(token -> texts.add(new Syntax.Text(token.start(), "")));
    WhiteSpace whiteSpace = new WhiteSpace(BodyTree.of(source, tokens));
    for (Body body : whiteSpace.tree.bodies()) {
      for (int i = 0; i < body.parts().size(); i++) {
        Part part = body.parts().get(i);
        if (part.isText()) {
          texts.set(part.token(), whiteSpace.text(body, i));
        }
      }
    }
    return texts;
  }

  private Syntax.Text text(Body body, int index) {
    Part part = body.parts().get(index);
    String whole = part.text();
    if (body.isModule()) {
      return new Syntax.Text(part.start(), whole);
    }
    int from = takesStart(body, index) ? BlankLines.firstOf(whole) : 0;
    String rest = whole.substring(from);
    String kept = rest.substring(0, rest.length() - takenAtEnd(body, index, rest));
    return new Syntax.Text(part.start() + from, kept);
  }

  private boolean takesStart(Body body, int index) {
    if (index == 0) {
      return !body.isArea() && !body.isOnOneLine();
    }
    return !isOnSpeakingLine(body, index, true) || isOverLines(body.parts().get(index - 1));
  }

  /** Returns the number of characters that a text loses at its end. */
  private int takenAtEnd(Body body, int index, String rest) {
    boolean last = index + 1 == body.parts().size();
    if (last && body.isTemplate()) {
      String whole = body.parts().get(index).text();
      return BlankLines.lastOf(rest, BlankLines.isSecondOfTwoBreaks(whole, rest));
    }
    boolean takes =
        (last && !body.isOnOneLine())
            || !isOnSpeakingLine(body, index, false)
            || (!last && isBlockOverLines(body.parts().get(index + 1)));
    return takes ? BlankLines.lastOf(rest, true) : 0;
  }

  /** Returns whether a part is a block of several lines other than a protected area. */
  private static boolean isOverLines(Part part) {
    return isBlockOverLines(part) && !part.isArea();
  }

  private static boolean isBlockOverLines(Part part) {
    return part.isBlock() && !part.isOnOneLine();
  }

  /**
   * Returns whether the line on which a text starts, or ends, speaks. Of a text within a line, what
   * follows decides; what is before decides only if nothing follows.
   */
  private static boolean isOnSpeakingLine(Body body, int index, boolean start) {
    List<Part> parts = body.parts();
    Part part = parts.get(index);
    boolean within = part.isOnOneLine();
    if (body.isOnOneLine() || (within && !part.text().isBlank())) {
      return true;
    }
    boolean speaks = true;
    if (index > 0 && (within || (start && BlankLines.startsWithOne(part.text())))) {
      speaks = speaks(parts, index - 1, -1);
    }
    if (index + 1 < parts.size() && (within || (!start && BlankLines.endsWithOne(part.text())))) {
      speaks = speaks(parts, index + 1, 1);
    }
    return speaks;
  }

  /** Returns whether a line speaks, from a part on to its beginning (-1) or its end (1). */
  private static boolean speaks(List<Part> parts, int index, int step) {
    int next = index;
    while (next + step > 0 && next + step < parts.size() - 1 && parts.get(next).isOnOneLine()) {
      if (isSpeaking(parts.get(next), step)) {
        return true;
      }
      next += step;
    }
    Part end = parts.get(next);
    return end.isText() ? !isBlankTowards(end.text(), step) : isSpeaking(end, step);
  }

  private static boolean isSpeaking(Part part, int step) {
    if (part.isText()) {
      return !part.text().isBlank();
    }
    if (part.isComment()) {
      return false;
    }
    if (!part.isBlock() || part.isArea()) {
      return true;
    }
    List<Part> inner = part.body().parts();
    return !inner.isEmpty() && speaks(inner, step < 0 ? inner.size() - 1 : 0, step);
  }

  private static boolean isBlankTowards(String text, int step) {
    return step < 0 ? BlankLines.endsWithOne(text) : BlankLines.startsWithOne(text);
  }
}
