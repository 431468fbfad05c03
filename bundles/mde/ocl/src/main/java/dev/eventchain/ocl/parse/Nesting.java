package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;

/** Parentheses and braces of a text, looked at once, since there may be thousands in each other. */
final class Nesting {

  private final int[] depths;
  private final BitSet withBar = new BitSet();

  Nesting(Tokens tokens) {
    depths = new int[tokens.size()];
    Deque<Integer> open = new ArrayDeque<>();
    int depth = 0;
    for (int i = 0; i < depths.length; i++) {
      depths[i] = depth;
      if (opens(tokens, i)) {
        open.push(i);
        depth++;
      } else if (closes(tokens, i)) {
        open.poll();
        depth--;
      } else if (tokens.is(i, "|") && !open.isEmpty()) {
        withBar.set(open.peek());
      }
    }
  }

  static boolean closes(Tokens tokens, int index) {
    return tokens.is(index, ")") || tokens.is(index, "}");
  }

  private static boolean opens(Tokens tokens, int index) {
    return tokens.is(index, "(") || tokens.is(index, "{");
  }

  /** Returns how many are open before a token; less than 0 if more were closed than opened. */
  int depth(int index) {
    return depths[index];
  }

  /** Returns whether a token opens some with a bar directly inside. */
  boolean hasBar(int index) {
    return withBar.get(index);
  }
}
