/** Reader of networks on CAN in system descriptions of AUTOSAR. */
package dev.eventchain.catalogue.arxml;
