<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>wcam::gui::ImportDialog</name>
    <message numerus="yes">
        <source>no, %n border(s)</source>
        <translation>
            <numerusform>no, %n border</numerusform>
            <numerusform>no, %n borders</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wcam::gui::LayerSlider</name>
    <message numerus="yes">
        <source>%n layer(s)</source>
        <translation>
            <numerusform>%n layer</numerusform>
            <numerusform>%n layers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wcam::gui::MainWindow</name>
    <message numerus="yes">
        <source>%n layer(s)</source>
        <translation>
            <numerusform>%n layer</numerusform>
            <numerusform>%n layers</numerusform>
        </translation>
    </message>
</context>
</TS>
