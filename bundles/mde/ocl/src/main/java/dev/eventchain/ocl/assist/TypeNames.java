package dev.eventchain.ocl.assist;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.editing.Mention;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EClassifier;

/** The names of classes and data types in the text of a type, such as {@code Set(lib::Book)}. */
public final class TypeNames {

  private TypeNames() {}

  /** Returns the names that packages know, in the order of the text. */
  public static List<Mention> in(SourceRange range, PackageIndex packages) {
    Tokens tokens = new Tokens(range.text());
    List<Mention> found = new ArrayList<>();
    List<String> path = new ArrayList<>();
    for (int i = 0; i < tokens.size(); i++) {
      if (!tokens.isName(i)) {
        continue;
      }
      path.add(tokens.text(i));
      if (!tokens.is(i + 1, "::")) {
        List<EClassifier> types = packages.classifiers(path);
        if (types.size() == 1) {
          int start = range.start() + tokens.start(i);
          found.add(mention(start, tokens.text(i), types.get(0)));
        }
        path.clear();
      }
    }
    return found;
  }

  /** Returns the mention of a type at an offset. */
  public static Mention mention(int start, String name, EClassifier type) {
    return new Mention(
        start, start + name.length(), Mention.Kind.TYPE, name, type, type, null, Mention.ELSEWHERE);
  }
}
