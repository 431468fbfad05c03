package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.Symbol;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.eclipse.jface.viewers.DelegatingStyledCellLabelProvider;
import org.eclipse.jface.viewers.DelegatingStyledCellLabelProvider.IStyledLabelProvider;
import org.eclipse.jface.viewers.ITreeContentProvider;
import org.eclipse.jface.viewers.LabelProvider;
import org.eclipse.jface.viewers.StyledString;
import org.eclipse.jface.viewers.TreeViewer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.ui.views.contentoutline.ContentOutlinePage;

/** The outline of a file's declarations; a click selects one. */
final class CodeOutline extends ContentOutlinePage {

  /**
   * A symbol in the tree, which is the same as one of an earlier text if it has the same names
   * around it: so it stays expanded and selected.
   */
  private record Entry(List<String> names, Symbol symbol) {

    static List<Entry> of(List<String> around, List<Symbol> symbols) {
      List<Entry> entries = new ArrayList<>();
      for (Symbol symbol : symbols) {
        List<String> names = new ArrayList<>(around);
        long same = entries.stream().filter(e -> e.symbol().name().equals(symbol.name())).count();
        names.add(symbol.name() + " " + same);
        entries.add(new Entry(names, symbol));
      }
      return entries;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Entry entry && entry.names.equals(names);
    }

    @Override
    public int hashCode() {
      return names.hashCode();
    }
  }

  private final Consumer<Symbol> show;
  private List<Symbol> symbols;
  private List<Entry> shown = List.of();

  CodeOutline(List<Symbol> symbols, Consumer<Symbol> show) {
    this.symbols = symbols;
    this.show = show;
  }

  @Override
  public void createControl(Composite parent) {
    super.createControl(parent);
    TreeViewer viewer = getTreeViewer();
    viewer.setAutoExpandLevel(2);
    viewer.setContentProvider(new Content());
    viewer.setLabelProvider(new DelegatingStyledCellLabelProvider(new Labels()));
    shown = Entry.of(List.of(), symbols);
    viewer.setInput(shown);
    viewer.addSelectionChangedListener(
        event -> {
          Object first = event.getStructuredSelection().getFirstElement();
          if (first instanceof Entry entry && getControl().isFocusControl()) {
            show.accept(entry.symbol());
          }
        });
  }

  /** Shows other symbols. */
  void show(List<Symbol> now) {
    if (now.equals(symbols)) {
      return;
    }
    symbols = now;
    TreeViewer viewer = getTreeViewer();
    if (viewer != null && !getControl().isDisposed()) {
      List<Object> expanded = List.of(viewer.getExpandedElements());
      List<Entry> collapsed = new ArrayList<>(shown);
      collapsed.removeAll(expanded);
      shown = Entry.of(List.of(), now);
      getControl().setRedraw(false);
      viewer.setInput(shown); // expands the contexts
      collapsed.forEach(each -> viewer.setExpandedState(each, false));
      expanded.forEach(each -> viewer.setExpandedState(each, true));
      getControl().setRedraw(true);
    }
  }

  private static final class Labels extends LabelProvider implements IStyledLabelProvider {
    @Override
    public String getText(Object element) {
      return getStyledText(element).getString();
    }

    @Override
    public StyledString getStyledText(Object element) {
      Symbol symbol = ((Entry) element).symbol();
      StyledString text = new StyledString(symbol.name());
      if (!symbol.detail().isEmpty()) {
        text.append(" " + symbol.detail(), StyledString.DECORATIONS_STYLER);
      }
      return text;
    }
  }

  private static final class Content implements ITreeContentProvider {
    @Override
    public Object[] getElements(Object input) {
      return ((List<?>) input).toArray();
    }

    @Override
    public Object[] getChildren(Object parent) {
      Entry entry = (Entry) parent;
      return Entry.of(entry.names(), entry.symbol().children()).toArray();
    }

    @Override
    public Object getParent(Object element) {
      return null; // the viewer does not need it for what it shows
    }

    @Override
    public boolean hasChildren(Object element) {
      return !((Entry) element).symbol().children().isEmpty();
    }
  }
}
