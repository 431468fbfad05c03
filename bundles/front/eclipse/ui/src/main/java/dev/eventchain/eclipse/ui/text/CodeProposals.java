package dev.eventchain.eclipse.ui.text;

import dev.eventchain.m2t.TemplateParts;
import dev.eventchain.ocl.text.Keywords;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.contentassist.CompletionProposal;
import org.eclipse.jface.text.contentassist.ICompletionProposal;
import org.eclipse.jface.text.contentassist.IContentAssistProcessor;
import org.eclipse.jface.text.contentassist.IContextInformation;
import org.eclipse.jface.text.contentassist.IContextInformationValidator;

/**
 * Proposes keywords and classes, and after a dot features: those of the preceding expression's
 * class if the text determines it, else those of all classes.
 */
final class CodeProposals implements IContentAssistProcessor {

  private static final Pattern PATH = Pattern.compile("([A-Za-z_]\\w*(?:\\.[A-Za-z_]\\w*)*)\\.$");

  private final Language language;
  private final Supplier<Vocabulary> names;

  CodeProposals(Language language, Supplier<Vocabulary> names) {
    this.language = language;
    this.names = names;
  }

  @Override
  public ICompletionProposal[] computeCompletionProposals(ITextViewer viewer, int offset) {
    String text = viewer.getDocument().get().substring(0, offset);
    int start = offset;
    while (start > 0 && Character.isJavaIdentifierPart(text.charAt(start - 1))) {
      start--;
    }
    String typed = text.substring(start).toLowerCase(Locale.ROOT);
    List<ICompletionProposal> proposals = new ArrayList<>();
    for (String name : all(text.substring(0, start))) {
      if (name.toLowerCase(Locale.ROOT).startsWith(typed)) {
        proposals.add(new CompletionProposal(name, start, offset - start, name.length()));
      }
    }
    return proposals.toArray(ICompletionProposal[]::new);
  }

  private Collection<String> all(String before) {
    if (before.endsWith(".")) {
      return features(before);
    } else if (language == Language.TEMPLATE && before.matches("(?s).*\\[\\s*/?")) {
      return inOrder(TemplateParts.KEYWORDS, Keywords.ALL, names.get().types());
    } else if (language == Language.TEMPLATE) {
      return inOrder(TemplateParts.MODIFIERS, Keywords.ALL, Keywords.TYPES, names.get().types());
    }
    return inOrder(Keywords.ALL, Keywords.TYPES, names.get().types());
  }

  @SafeVarargs
  private static Collection<String> inOrder(Collection<String>... names) {
    Set<String> all = new TreeSet<>(String.CASE_INSENSITIVE_ORDER.thenComparing(order()));
    Arrays.stream(names).forEach(all::addAll);
    return all;
  }

  private static Comparator<String> order() {
    return Comparator.naturalOrder();
  }

  private Collection<String> features(String before) {
    Vocabulary known = names.get();
    Matcher path = PATH.matcher(before);
    if (!path.find()) {
      return known.features();
    }
    List<String> steps = List.of(path.group(1).split("\\."));
    Set<String> found =
        type(before, steps.get(0))
            .flatMap(type -> known.follow(type, steps.subList(1, steps.size())))
            .map(known::features)
            .orElse(Set.of());
    return found.isEmpty() ? known.features() : found;
  }

  /** Returns the class of a variable: of the context, or of its last declaration in the text. */
  private Optional<String> type(String before, String variable) {
    String name = "";
    if (variable.equals("self") && language == Language.OCL) {
      name = Outlines.contextAt(before, before.length());
    } else {
      Pattern declared =
          Pattern.compile("\\b" + variable + "\\s*:\\s*([A-Za-z_]\\w*(?:::[A-Za-z_]\\w*)*)");
      Matcher found = declared.matcher(before);
      while (found.find()) {
        name = found.group(1);
      }
    }
    String last = name.substring(name.lastIndexOf(':') + 1);
    return last.isEmpty() ? Optional.empty() : Optional.of(last);
  }

  @Override
  public IContextInformation[] computeContextInformation(ITextViewer viewer, int offset) {
    return new IContextInformation[0];
  }

  @Override
  public char[] getCompletionProposalAutoActivationCharacters() {
    return new char[] {'.', '['};
  }

  @Override
  public char[] getContextInformationAutoActivationCharacters() {
    return new char[0];
  }

  @Override
  public String getErrorMessage() {
    return null; // the platform's value for no error
  }

  @Override
  public IContextInformationValidator getContextInformationValidator() {
    return null; // there is no such information
  }
}
