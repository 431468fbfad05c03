package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.eclipse.ui.editor.model.ModelFile;
import java.util.List;
import java.util.function.IntConsumer;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.jface.layout.GridLayoutFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Table;
import org.eclipse.swt.widgets.TableColumn;
import org.eclipse.swt.widgets.TableItem;
import org.eclipse.ui.forms.widgets.FormToolkit;
import org.eclipse.ui.forms.widgets.ScrolledForm;

/** The page of an editor for an invalid model file: lists its problems by line. */
final class BrokenPage {

  private static final int LINE_WIDTH = 70;
  private static final int MESSAGE_WIDTH = 900;

  /**
   * @param openAsText opens the file as text, at a line if known
   */
  BrokenPage(Composite parent, List<ModelFile.Problem> problems, IntConsumer openAsText) {
    Composite area = new Composite(parent, SWT.NONE);
    GridLayoutFactory.fillDefaults().applyTo(area);
    FormToolkit toolkit = new FormToolkit(area.getDisplay());
    area.addDisposeListener(event -> toolkit.dispose());
    ScrolledForm form = toolkit.createScrolledForm(area);
    GridDataFactory.fillDefaults().grab(true, true).applyTo(form);
    toolkit.decorateFormHeading(form.getForm());
    form.setText("This file cannot be read as an event chain");
    GridLayoutFactory.swtDefaults().margins(10, 10).applyTo(form.getBody());
    toolkit.createLabel(
        form.getBody(),
        "Nothing is lost. Fix it as text; once it is saved, the editor shows the chain.");
    Button open = toolkit.createButton(form.getBody(), "Open as text", SWT.PUSH);
    Table table = table(toolkit, form.getBody());
    open.addListener(SWT.Selection, event -> openAsText.accept(line(problems, 0)));
    table.addListener(
        SWT.DefaultSelection,
        event -> openAsText.accept(line(problems, table.getSelectionIndex())));
    for (ModelFile.Problem problem : problems) {
      TableItem item = new TableItem(table, SWT.NONE);
      String hint = problem.hint().isEmpty() ? "" : " " + problem.hint();
      String line = problem.line() == 0 ? "" : String.valueOf(problem.line());
      item.setText(new String[] {line, problem.message() + hint});
    }
  }

  private static Table table(FormToolkit toolkit, Composite parent) {
    Table table = toolkit.createTable(parent, SWT.FULL_SELECTION | SWT.BORDER);
    GridDataFactory.fillDefaults().grab(true, true).hint(400, 200).applyTo(table);
    table.setHeaderVisible(true);
    TableColumn line = new TableColumn(table, SWT.RIGHT);
    line.setText("Line");
    line.setWidth(LINE_WIDTH);
    TableColumn message = new TableColumn(table, SWT.LEFT);
    message.setText("What is wrong");
    message.setWidth(MESSAGE_WIDTH);
    return table;
  }

  private static int line(List<ModelFile.Problem> problems, int index) {
    return index >= 0 && index < problems.size() ? problems.get(index).line() : 0;
  }
}
