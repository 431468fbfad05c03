/** Reader of networks in DBC. */
package dev.eventchain.catalogue.dbc;
