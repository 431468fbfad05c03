package dev.eventchain.lsp.language;

import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.SignatureHelp;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextRange;
import dev.eventchain.lsp.text.Positions;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionItemKind;
import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.FoldingRange;
import org.eclipse.lsp4j.FoldingRangeKind;
import org.eclipse.lsp4j.InsertTextFormat;
import org.eclipse.lsp4j.MarkupContent;
import org.eclipse.lsp4j.MarkupKind;
import org.eclipse.lsp4j.ParameterInformation;
import org.eclipse.lsp4j.SelectionRange;
import org.eclipse.lsp4j.SemanticTokensLegend;
import org.eclipse.lsp4j.SignatureInformation;
import org.eclipse.lsp4j.SymbolKind;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

/** Values of the analyses in the words of the protocol. */
public final class Protocol {

  private static final List<SemanticToken.Kind> KINDS = List.of(SemanticToken.Kind.values());

  private Protocol() {}

  /** Returns a text in Markdown. */
  public static MarkupContent markdown(String text) {
    return new MarkupContent(MarkupKind.MARKDOWN, text);
  }

  /** Returns a part of an outline, with its parts. */
  public static DocumentSymbol symbol(Symbol symbol) {
    DocumentSymbol converted =
        new DocumentSymbol(
            symbol.name(),
            symbolKind(symbol.kind()),
            Positions.of(symbol.range()),
            Positions.of(symbol.nameRange()));
    if (!symbol.detail().isEmpty()) {
      converted.setDetail(symbol.detail());
    }
    converted.setChildren(symbol.children().stream().map(Protocol::symbol).toList());
    return converted;
  }

  /** Returns the kind that the protocol has for a kind of ours. */
  public static SymbolKind symbolKind(ElementKind kind) {
    return switch (kind) {
      case FILE -> SymbolKind.File;
      case MODULE -> SymbolKind.Module;
      case PACKAGE -> SymbolKind.Package;
      case CLASS, STANDARD_TYPE, CONTEXT -> SymbolKind.Class;
      case DATA_TYPE -> SymbolKind.Struct;
      case ENUMERATION -> SymbolKind.Enum;
      case ENUMERATION_LITERAL -> SymbolKind.EnumMember;
      case ATTRIBUTE -> SymbolKind.Property;
      case REFERENCE -> SymbolKind.Field;
      case OPERATION, ITERATOR, DEFINITION -> SymbolKind.Method;
      case TEMPLATE, QUERY -> SymbolKind.Function;
      case INVARIANT -> SymbolKind.Boolean;
      case VARIABLE, PARAMETER -> SymbolKind.Variable;
      case BLOCK, ANNOTATION, KEYWORD, SNIPPET -> SymbolKind.Object;
    };
  }

  /** Returns proposals in the order in which they are given. */
  public static List<CompletionItem> completions(List<Completion> proposals) {
    List<CompletionItem> items = new ArrayList<>();
    for (Completion each : proposals) {
      CompletionItem item = new CompletionItem(each.label());
      item.setKind(completionKind(each.kind()));
      if (!each.detail().isEmpty()) {
        item.setDetail(each.detail());
      }
      if (!each.documentation().isEmpty()) {
        item.setDocumentation(markdown(each.documentation()));
      }
      item.setInsertTextFormat(
          each.snippet() ? InsertTextFormat.Snippet : InsertTextFormat.PlainText);
      item.setTextEdit(
          Either.forLeft(new TextEdit(Positions.of(each.replaced()), each.insertText())));
      item.setSortText(String.format(Locale.ROOT, "%05d", items.size()));
      items.add(item);
    }
    return items;
  }

  private static CompletionItemKind completionKind(ElementKind kind) {
    return switch (kind) {
      case FILE -> CompletionItemKind.File;
      case MODULE, PACKAGE -> CompletionItemKind.Module;
      case CLASS, STANDARD_TYPE, CONTEXT -> CompletionItemKind.Class;
      case DATA_TYPE -> CompletionItemKind.Struct;
      case ENUMERATION -> CompletionItemKind.Enum;
      case ENUMERATION_LITERAL -> CompletionItemKind.EnumMember;
      case ATTRIBUTE -> CompletionItemKind.Property;
      case REFERENCE -> CompletionItemKind.Field;
      case OPERATION, ITERATOR, DEFINITION -> CompletionItemKind.Method;
      case TEMPLATE, QUERY, INVARIANT -> CompletionItemKind.Function;
      case VARIABLE, PARAMETER -> CompletionItemKind.Variable;
      case KEYWORD, BLOCK, ANNOTATION -> CompletionItemKind.Keyword;
      case SNIPPET -> CompletionItemKind.Snippet;
    };
  }

  /** Returns lines that can be folded. */
  public static FoldingRange folding(Folding folding) {
    FoldingRange converted = new FoldingRange(folding.firstLine(), folding.lastLine());
    switch (folding.kind()) {
      case COMMENT -> converted.setKind(FoldingRangeKind.Comment);
      case IMPORTS -> converted.setKind(FoldingRangeKind.Imports);
      case BLOCK -> {
        // The protocol has no kind for it.
      }
    }
    return converted;
  }

  /** Returns signatures, with the argument at which the cursor is. */
  public static org.eclipse.lsp4j.SignatureHelp signatures(SignatureHelp help) {
    List<SignatureInformation> converted = new ArrayList<>();
    for (SignatureHelp.Signature each : help.signatures()) {
      SignatureInformation information = new SignatureInformation(each.label());
      if (!each.documentation().isEmpty()) {
        information.setDocumentation(markdown(each.documentation()));
      }
      information.setParameters(each.parameters().stream().map(ParameterInformation::new).toList());
      converted.add(information);
    }
    return new org.eclipse.lsp4j.SignatureHelp(converted, 0, help.activeParameter());
  }

  /** Returns the innermost of ranges, each with the next as its parent. */
  public static SelectionRange selection(List<TextRange> ranges, TextRange otherwise) {
    SelectionRange around = null;
    for (int i = ranges.size() - 1; i >= 0; i--) {
      around = new SelectionRange(Positions.of(ranges.get(i)), around);
    }
    return around == null ? new SelectionRange(Positions.of(otherwise), null) : around;
  }

  /** Returns the names of what tokens mean, in the order of the kinds. */
  public static SemanticTokensLegend legend() {
    List<String> types = KINDS.stream().map(Protocol::tokenType).toList();
    return new SemanticTokensLegend(types, List.of("declaration"));
  }

  private static String tokenType(SemanticToken.Kind kind) {
    return switch (kind) {
      case KEYWORD -> "keyword";
      case COMMENT -> "comment";
      case STRING -> "string";
      case NUMBER -> "number";
      case OPERATOR -> "operator";
      case TYPE -> "type";
      case ENUMERATION_LITERAL -> "enumMember";
      case NAMESPACE -> "namespace";
      case PROPERTY -> "property";
      case OPERATION -> "method";
      case FUNCTION -> "function";
      case VARIABLE -> "variable";
      case PARAMETER -> "parameter";
      case ANNOTATION -> "decorator";
    };
  }

  /** Returns tokens as numbers, each place relative to the one before. */
  public static List<Integer> tokens(List<SemanticToken> tokens) {
    List<Integer> data = new ArrayList<>(tokens.size() * 5);
    int line = 0;
    int column = 0;
    for (SemanticToken each : tokens) {
      data.add(each.line() - line);
      data.add(each.line() == line ? each.column() - column : each.column());
      data.add(each.length());
      data.add(KINDS.indexOf(each.kind()));
      data.add(each.declaration() ? 1 : 0);
      line = each.line();
      column = each.column();
    }
    return data;
  }
}
