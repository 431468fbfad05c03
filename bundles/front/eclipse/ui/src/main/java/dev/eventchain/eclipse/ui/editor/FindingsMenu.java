package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.eclipse.ui.editor.model.Labels;
import dev.eventchain.eclipse.ui.editor.validation.ElementFinding;
import java.util.function.Consumer;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.MenuManager;
import org.eclipse.ui.ISharedImages;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.forms.events.HyperlinkEvent;
import org.eclipse.ui.forms.events.IHyperlinkListener;
import org.eclipse.ui.forms.widgets.Form;

/** The list of findings that opens from the message in an editor's heading. */
final class FindingsMenu {

  /** Largest number of entries that fits on a screen. */
  private static final int MOST = 25;

  private static final int LONGEST = 160;

  private FindingsMenu() {}

  /** Opens the list on a click; choosing an entry shows the element of the finding. */
  static void open(Form form, ShownFindings findings, Consumer<EObject> reveal) {
    form.addMessageHyperlinkListener(
        IHyperlinkListener.linkActivatedAdapter(
            (HyperlinkEvent event) -> {
              MenuManager menu = new MenuManager();
              findings.all().stream().limit(MOST).forEach(each -> menu.add(action(each, reveal)));
              menu.createContextMenu(form).setVisible(true);
            }));
  }

  private static Action action(ElementFinding finding, Consumer<EObject> reveal) {
    String text = Labels.of(finding.element()).name() + ": " + finding.text();
    String brief = text.length() > LONGEST ? text.substring(0, LONGEST) + "\u2026" : text;
    Action action =
        new Action(brief.replace("&", "&&").replace("\t", " ")) {
          @Override
          public void run() {
            reveal.accept(finding.element());
          }
        };
    String icon =
        switch (finding.severity()) {
          case ERROR -> ISharedImages.IMG_OBJS_ERROR_TSK;
          case WARNING -> ISharedImages.IMG_OBJS_WARN_TSK;
          case INFO -> ISharedImages.IMG_OBJS_INFO_TSK;
        };
    action.setImageDescriptor(PlatformUI.getWorkbench().getSharedImages().getImageDescriptor(icon));
    return action;
  }
}
