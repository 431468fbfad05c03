package dev.eventchain.xmi;

import dev.eventchain.uml.Uml;
import org.eclipse.emf.ecore.EFactory;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.impl.EPackageRegistryImpl;
import org.eclipse.emf.ecore.xml.namespace.XMLNamespacePackage;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;

/**
 * The metamodels of a store by their namespaces. Ecore is always one of them; UML is known too, and
 * loaded when a file first names it, since that takes more than a second.
 */
final class KnownPackages extends EPackageRegistryImpl {

  private static final long serialVersionUID = 1L;

  KnownPackages() {
    put(EcorePackage.eNS_URI, EcorePackage.eINSTANCE);
    put(XMLTypePackage.eNS_URI, XMLTypePackage.eINSTANCE);
    put(XMLNamespacePackage.eNS_URI, XMLNamespacePackage.eINSTANCE);
  }

  @Override
  protected EPackage delegatedGetEPackage(String nsURI) {
    return Uml.metamodel(nsURI).orElse(null);
  }

  @Override
  protected EFactory delegatedGetEFactory(String nsURI) {
    return Uml.metamodel(nsURI).map(EPackage::getEFactoryInstance).orElse(null);
  }

  @Override
  public boolean containsKey(Object key) {
    return super.containsKey(key)
        || (key instanceof String nsUri && Uml.metamodel(nsUri).isPresent());
  }
}
