package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.metamodel.PackageIndex;
import java.util.List;
import java.util.Set;
import lpg.runtime.PrsStream;
import org.eclipse.ocl.parser.OCLParsersym;

/**
 * Allows classes named like a kind of collection. OCL reserves these words, but only needs them
 * before a parenthesis or a brace: {@code Set(Node)}, {@code Set{1}}.
 */
final class KeywordNames {

  private static final Set<Integer> KINDS =
      Set.of(
          OCLParsersym.TK_Set,
          OCLParsersym.TK_Bag,
          OCLParsersym.TK_Sequence,
          OCLParsersym.TK_Collection,
          OCLParsersym.TK_OrderedSet,
          OCLParsersym.TK_Tuple);

  private static final Set<Integer> OPENING =
      Set.of(OCLParsersym.TK_LPAREN, OCLParsersym.TK_LBRACE);

  private KeywordNames() {}

  /** Turns these keywords into names where they denote a class. */
  static void release(PrsStream tokens, PackageIndex packages) {
    for (int i = 0; i < tokens.getSize() - 1; i++) {
      boolean kind = KINDS.contains(tokens.getKind(i)) && !OPENING.contains(tokens.getKind(i + 1));
      if (kind && !packages.classifiers(List.of(tokens.getTokenText(i))).isEmpty()) {
        tokens.getIToken(i).setKind(OCLParsersym.TK_IDENTIFIER);
      }
    }
  }
}
